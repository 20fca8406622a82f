// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "boundary_report.h"

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <cmath>
#include <string>

namespace conformal {
namespace {

using Kind = CGP::Boundary_condition::Kind;

const double degrees = 180 / std::acos(-1.);

bool is_closed(const CGP::Mesh_view& mesh)
{
  return CGP::topology(mesh).is_closed();
}

/// of the disk of the same area; finite for whatever size the mesh is of
double radius(CGP::Mesh_view mesh)
{
  const CGP::internal::Normalized_frame frame(mesh.positions());
  mesh.set_positions(frame.to_frame(mesh.positions()));
  return frame.unit() * std::sqrt(CGP::total_area(mesh) / std::acos(-1.));
}

std::string name_of(const CGP::Boundary_condition& condition)
{
  if (condition.kind == Kind::free) return "free";
  if (condition.kind == Kind::positions) return "positions";
  const std::string what = condition.direction.x() == 0 ? "binormals" : "tangents";
  return what + (condition.targets.cols() == 0 ? " kept" : " prescribed");
}

}  // namespace

void report_boundary(const CGP::Mesh_view& mesh, const CGP::Boundary_condition& condition,
                     const CGP::Spin_report& spin, Report& report)
{
  if (is_closed(mesh)) return;
  report.set("result/boundary/condition", name_of(condition).c_str());
  report.set("result/boundary/gamma_radius", spin.eigenvalue * radius(mesh));
  if (condition.kind == Kind::directions) {
    report.set("result/boundary/direction_error/mean", spin.direction_error.mean * degrees);
    report.set("result/boundary/direction_error/max", spin.direction_error.max * degrees);
  }
  if (spin.boundary_fault == CGP::Spin_report::Boundary_fault::none)
    report.set("result/boundary/fault", Report::Value(nullptr));
  else
    report.set("result/boundary/fault", CGP::to_string(spin.boundary_fault));
}

void add_boundary(const CGP::Mesh_view& mesh, const CGP::Boundary_condition& condition,
                  const CGP::Spin_report& spin, Table& table)
{
  if (is_closed(mesh)) return;
  table.add("boundary", name_of(condition));
  table.add("gamma times the radius", text_of(spin.eigenvalue * radius(mesh), 3));
  if (condition.kind == Kind::directions)
    table.add("directions missed by (degrees)",
              text_of(spin.direction_error.mean * degrees, 3) + " in the mean, " +
                  text_of(spin.direction_error.max * degrees, 3) + " at most");
}

}  // namespace conformal
