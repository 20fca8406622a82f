// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "boundary_report.h"

#include "conformal/process/text.h"

#include <Conformal_geometry_processing/mesh/topology.h>

#include <cmath>
#include <string>

namespace conformal {
namespace {

using Kind = CGP::Boundary_condition::Kind;

const double degrees = 180 / std::acos(-1.);

std::string name_of(const CGP::Boundary_condition& condition)
{
  if (condition.kind == Kind::free) return "free";
  if (condition.kind == Kind::positions) return "positions";
  const std::string what = condition.direction.x() == 0 ? "binormals" : "tangents";
  return what + (condition.targets.cols() == 0 ? " kept" : " prescribed");
}

void tell_directions(const CGP::Spin_report& spin, Report& report)
{
  const double mean = spin.direction_error.mean * degrees, max = spin.direction_error.max * degrees;
  report.set("result/boundary/direction_error/mean", mean);
  report.set("result/boundary/direction_error/max", max);
  report.show("directions missed by (degrees)",
              text_of(mean, 3) + " in the mean, " + text_of(max, 3) + " at most");
}

void tell_positions(const CGP::Spin_report& spin, Report& report)
{
  report.set("result/boundary/position_error/mean", spin.position_error.mean);
  report.set("result/boundary/position_error/max", spin.position_error.max);
  report.show("positions missed by", text_of(spin.position_error.mean, 3) + " in the mean, " +
                                         text_of(spin.position_error.max, 3) + " at most");
}

}  // namespace

void tell_boundary(const CGP::Mesh_view& mesh, const CGP::Boundary_condition& condition,
                   const CGP::Spin_report& spin, Report& report)
{
  if (CGP::topology(mesh).is_closed()) return;
  report.set("result/boundary/condition", name_of(condition).c_str());
  report.show("boundary", name_of(condition));
  report.tell("result/boundary/gamma_radius", "gamma times the radius", spin.gamma_radius(), 3);
  if (condition.kind == Kind::directions) tell_directions(spin, report);
  if (condition.kind == Kind::positions) tell_positions(spin, report);
  if (spin.boundary_fault == CGP::Spin_report::Boundary_fault::none)
    report.set("result/boundary/fault", Report::Value(nullptr));
  else
    report.set("result/boundary/fault", CGP::to_string(spin.boundary_fault));
}

}  // namespace conformal
