// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Curve_flows.h"

#include "conformal/process/Failure.h"

#include <algorithm>
#include <utility>

namespace conformal {
namespace {

CGP::Curve_flow_options options_of(const Plane_curve& curve, const Curve_options& options)
{
  CGP::Curve_flow_options flow;
  flow.is_closed = curve.is_closed;
  flow.time_step = options.time_step;
  flow.closing = options.closing == Closing_choice::exact
                     ? CGP::Curve_flow_options::Closing::exact
                     : CGP::Curve_flow_options::Closing::least_squares;
  return flow;
}

CGP::Isometric_curve_flow flow_of(const Plane_curve& curve, const Curve_options& options)
{
  try {
    return CGP::Isometric_curve_flow(curve.points, options_of(curve, options));
  } catch (const CGP::Precondition_error& error) {
    throw unsuitable(options.input, curve.name + ": " + error.message());
  }
}

}  // namespace

Curve_flows::Curve_flows(const std::vector<Plane_curve>& curves, const Curve_options& options)
{
  for (const Plane_curve& curve : curves) {
    CGP::Isometric_curve_flow flow = flow_of(curve, options);
    const double energy = flow.energy();
    m_all.push_back({curve.name, std::move(flow), energy, CGP::Curve_step_report::Stop::none, {}});
  }
}

bool Curve_flows::step()
{
  bool has_moved = false;
  for (One& one : m_all) {
    if (one.stop != CGP::Curve_step_report::Stop::none) continue;
    const CGP::Curve_step_report report = one.flow.step();
    one.stop = report.stop;
    if (report.accepted) one.steps.push_back(report);
    has_moved = has_moved || report.accepted;
  }
  return has_moved;
}

std::vector<Plane_curve> Curve_flows::curves() const
{
  std::vector<Plane_curve> curves;
  for (const One& one : m_all)
    curves.push_back({one.name, one.flow.points(), one.flow.is_closed()});
  return curves;
}

std::size_t Curve_flows::size_of_steps() const
{
  std::size_t size = 0;
  for (const One& one : m_all) size = std::max(size, one.steps.size());
  return size;
}

double Curve_flows::length_distortion() const
{
  double worst = 0;
  for (const One& one : m_all)
    if (!one.steps.empty()) worst = std::max(worst, one.steps.back().length_distortion);
  return worst;
}

}  // namespace conformal
