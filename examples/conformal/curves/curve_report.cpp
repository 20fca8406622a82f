// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "curve_report.h"

#include "conformal/process/interruption.h"
#include "conformal/process/text.h"

#include <cmath>
#include <functional>

namespace conformal {
namespace {

using One = Curve_flows::One;
using Step = CGP::Curve_step_report;

std::vector<double> of_each(const Curve_flows& flows,
                            const std::function<double(const One&)>& number)
{
  std::vector<double> numbers;
  for (const One& one : flows.all()) numbers.push_back(number(one));
  return numbers;
}

/// a number of step i, not a number where a curve has rested before it
std::vector<double> of_step(const Curve_flows& flows, std::size_t i,
                            const std::function<double(const Step&)>& number)
{
  return of_each(flows, [&](const One& one) {
    return i < one.steps.size() ? number(one.steps[i]) : std::nan("");
  });
}

void report_step(const Curve_flows& flows, std::size_t i, Report& report)
{
  const std::string place = "steps/" + std::to_string(i) + "/";
  const auto set = [&](const char* name, const std::function<double(const Step&)>& number) {
    report.set(place + name, Report::Value(of_step(flows, i, number)));
  };
  report.set(place + "step", static_cast<int>(i) + 1);
  set("energy", [](const Step& s) { return s.energy; });
  set("time_step", [](const Step& s) { return s.time_step; });
  set("trials", [](const Step& s) { return s.trials; });
  set("first_gap", [](const Step& s) { return s.first_gap; });
  set("closing_gap", [](const Step& s) { return s.gap; });
  set("newton_iterations", [](const Step& s) { return s.newton_iterations; });
  set("length_distortion", [](const Step& s) { return s.length_distortion; });
  set("turning_number", [](const Step& s) { return s.turning_number; });
}

double distortion(const One& one)
{
  return one.steps.empty() ? 0 : one.steps.back().length_distortion;
}

std::string reason(const One& one)
{
  if (one.stop != CGP::Curve_step_report::Stop::none) return CGP::to_string(one.stop);
  return signal_received() != 0 ? "interrupted"
                                : CGP::to_string(CGP::Curve_step_report::Stop::steps_done);
}

void report_curves(const Curve_flows& flows, Report& report)
{
  const auto set = [&](const char* place, const std::function<double(const One&)>& number) {
    report.set(place, Report::Value(of_each(flows, number)));
  };
  report.set("input/curves", static_cast<int>(flows.all().size()));
  set("input/points", [](const One& o) { return static_cast<double>(o.flow.points().cols()); });
  set("input/closed", [](const One& o) { return o.flow.is_closed() ? 1 : 0; });
  std::vector<std::string> stops;
  for (const One& one : flows.all()) stops.push_back(reason(one));
  report.set("result/steps", static_cast<int>(flows.size_of_steps()));
  report.set("result/stop", Report::Value(stops));
  set("result/length", [](const One& o) { return o.flow.length(); });
  set("result/turning_number", [](const One& o) { return o.flow.turning_number_of_curve(); });
  set("result/energy/initial", [](const One& o) { return o.initial_energy; });
  set("result/energy/final", [](const One& o) { return o.flow.energy(); });
  set("result/energy_times_length/initial",
      [](const One& o) { return o.initial_energy * o.flow.length(); });
  set("result/energy_times_length/final",
      [](const One& o) { return o.flow.energy() * o.flow.length(); });
  report.set("result/length_distortion", flows.length_distortion());
  report.set("steps", Report::Value(std::vector<double>()));
  for (std::size_t i = 0; i < flows.size_of_steps(); ++i) report_step(flows, i, report);
}

Grid step_grid(const One& one)
{
  Grid grid({"step", "energy*length", "time step", "trials", "gap", "closed to", "distortion"});
  for (const Step& s : one.steps)
    grid.add({std::to_string(s.step), text_of(s.energy * one.flow.length(), 8),
              text_of(s.time_step, 3), std::to_string(s.trials), text_of(s.first_gap, 3),
              text_of(s.gap, 3), text_of(s.length_distortion, 3)});
  return grid;
}

Grid curve_grid(const Curve_flows& flows)
{
  Grid grid({"curve", "points", "turns", "steps", "energy*length", "becomes", "distortion",
             "stopped because"});
  for (std::size_t i = 0; i < flows.all().size(); ++i) {
    const One& one = flows.all()[i];
    const double L = one.flow.length();
    grid.add({std::to_string(i), std::to_string(one.flow.points().cols()),
              one.flow.is_closed() ? std::to_string(one.flow.turning_number_of_curve()) : "open",
              std::to_string(one.steps.size()), text_of(one.initial_energy * L, 8),
              text_of(one.flow.energy() * L, 8), text_of(distortion(one), 3), reason(one)});
  }
  return grid;
}

}  // namespace

void tell_curves(const Curve_flows& flows, Report& report)
{
  report_curves(flows, report);
  if (flows.all().size() == 1) report.show(step_grid(flows.all().front()));
  report.show(curve_grid(flows));
}

}  // namespace conformal
