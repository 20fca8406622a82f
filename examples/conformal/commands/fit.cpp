// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "fit.h"

#include "conformal/input/Expression.h"
#include "conformal/input/boundary_condition.h"
#include "conformal/input/rho.h"
#include "conformal/input/same_faces.h"
#include "conformal/process/Failure.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/report/verification.h"
#include "conformal/transform/deform.h"
#include "conformal/transform/solve_fit.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <cmath>
#include <utility>

namespace conformal {
namespace {

const char* const easier_than_fit = "a target that is bent and sheared less";

/// Evaluates a formula for the factors at the vertices; empty if there is no formula.
Eigen::VectorXd scale_factors(const Surface_input& input, const std::string& text)
{
  if (text.empty()) return {};
  Expression expression(text, "--scale-expression");
  const User_frame frame(input.mesh);
  const CGP::Points normals = CGP::vertex_normals(input.mesh);
  Eigen::VectorXd factors(input.mesh.size_of_vertices());
  for (int v = 0; v < factors.size(); ++v) {
    factors[v] = expression(frame(input.mesh.position(v)), normals.col(v));
    if (!(factors[v] > 0) || !std::isfinite(factors[v]))
      throw unsuitable(input.file.path, "--scale-expression is " + text_of(factors[v]) + " at " +
                                            name_of_vertex(input, v) +
                                            ", wanted finite numbers above 0; try: exp(...)");
  }
  return factors;
}

CGP::Boundary_condition boundary_of(const Surface_input& input, const CGP::Mesh_view& target,
                                    Boundary_choice choice)
{
  if (CGP::topology(input.mesh).is_closed()) return CGP::Boundary_condition::free();
  return directions_of(input, target, choice);
}

/// Reports on the target: its distance from the surface, and its deviation from conformality
void tell_target(const Surface_input& input, const CGP::Mesh_view& target,
                 const Fit_solution& solution, Session& session)
{
  Report& report = session.report();
  Table table;
  const CGP::Mesh_view measured =
      measured_part(input.mesh, solution.spin.report.mollification.share > 0);
  const CGP::Conformality map = CGP::conformality(
      measured, target.positions(), CGP::neighbourhood_normals(measured, target.positions()));
  report.set("result/target/quasi_conformal/mean", map.quasi_conformal.mean);
  report.set("result/target/quasi_conformal/p99", map.quasi_conformal.p99);
  report.set("result/target/quasi_conformal/max", map.quasi_conformal.max);
  report.set("result/target/sign_conflicts", solution.sign_conflicts);
  table.add("quasi-conformal error of the target, mean", map.quasi_conformal.mean);
  table.add("quasi-conformal error of the target, max", map.quasi_conformal.max);
  if (solution.spin.report.converged) {
    const auto a = CGP::align(solution.spin.positions, target.positions());
    report.set("result/distance/rms", a.rms);
    report.set("result/distance/max", a.max);
    table.add("distance from the target, rms / diagonal", a.rms);
    table.add("distance from the target, max / diagonal", a.max);
  }
  session.print(table.text() + "\n");
  if (solution.sign_conflicts > 0)
    session.note("the rotations of the target jump by more than half a turn across " +
                 count_of(static_cast<std::size_t>(solution.sign_conflicts), "edge"));
}

Fit_solution solve(const Surface_input& input, const Fit_problem& problem, Session& session)
{
  Fit_solution solution;
  solution.spin = watched(
      [&](const Go_further& go_further) {
        solution = solve_fit(input.mesh, problem, session.options(), go_further);
        return std::move(solution.spin);
      },
      session.options());
  return solution;
}

}  // namespace

void fit(const Fit_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input =
      read_suitable_surface(options.spin.input, session, flat_faces(options.spin.mollification));
  const CGP::Mesh_view target =
      read_surface_like(input, options.target, flat_faces(options.spin.mollification)).mesh;
  session.note_all(notes_of_repair_alike(input, {options.target}));
  const CGP::Boundary_condition boundary = boundary_of(input, target, options.boundary);
  const Fit_problem problem{target.positions(), scale_factors(input, options.scale),
                            boundary.direction, options.blend,
                            options.spin.mollification.value_or(0)};
  session.end_stage("prepare");
  Fit_solution solution = solve(input, problem, session);
  session.begin_stage();
  tell_target(input, target, solution, session);
  solution.rho.values *= User_frame(input.mesh).unit();
  const Deformation deformation{std::move(solution.rho), boundary, std::move(solution.spin)};
  tell_certificate(input, deformation, session);
  verify(options.spin.input, input, deformation.solution, options.spin, easier_than_fit, session);
  keep_exhibit(input, deformation.solution.positions, session);
  write_deformation(session.options().output, input, deformation, options.spin.lambda, session);
  session.end_stage("write");
}

}  // namespace conformal
