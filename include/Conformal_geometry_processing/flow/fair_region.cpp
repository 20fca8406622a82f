// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/fair_region.h>

#include <Conformal_geometry_processing/flow/Class_fairing.h>
#include <Conformal_geometry_processing/flow/Outline_fairing.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Core>

#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// why there is no step: a surface that was good before is not lost
template <class Step>
std::string step_fault(const Step& step)
{
  try {
    step();
    return "";
  } catch (const Solver_error& error) {
    if (is_out_of_memory(error)) throw;
    return "no further step: " + error.message();
  }
}

/// takes steps from f until they are short
template <class Fairing>
void take_steps(const Fairing_patch& patch, Fairing& fairing, const Fairing_options& options,
                const std::function<bool()>& go_further, Points& f, Fairing_report& report)
{
  const Points& p = patch.mesh().positions();
  const double diagonal = (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
  report.message = "no step was asked for";
  for (int k = 0; k < options.max_steps; ++k) {
    if (!go_further()) {
      report.message = "cancelled";
      return;
    }
    Fairing_step next{f};
    report.message = step_fault([&] { next = fairing.step(Bending_energy(patch, f)); });
    if (!report.message.empty()) return;
    const double way = (next.f - f).colwise().norm().maxCoeff();
    report.converged = way <= options.tolerance * diagonal;
    if (next.is_lower) f = std::move(next.f), ++report.steps;
    if (report.converged) return;
    report.message = next.is_lower ? "all steps are done" : "no step lowers the energy";
    if (!next.is_lower) return;
  }
}

/// of the faces that move
inline Conformality map_of_region(const Fairing_patch& patch, const Points& f)
{
  std::vector<char> moves;
  for (int k = 0; k < patch.mesh().size_of_faces(); ++k) moves.push_back(patch.moves(k));
  const Mesh_component part = selected_faces(patch.mesh(), moves);
  const Points after = f(Eigen::indexing::all, part.vertices);
  return conformality(part.mesh, after, neighbourhood_normals(part.mesh, after));
}

}  // namespace internal

internal::Fairing_result internal::fair_region(const Mesh_view& mesh,
                                               const std::vector<char>& is_in_region,
                                               const Fairing_options& options,
                                               const std::string& function,
                                               const std::function<bool()>& go_further)
{
  require_not_empty(mesh, function);
  require_finite_positions(mesh, function);
  require_distinct_corners(mesh, function);
  require_manifold_edges(mesh, function);
  require_manifold_vertices(mesh, function);
  const Normalized_frame frame(mesh.positions());
  const Mesh_view framed(frame.to_frame(mesh.positions()), mesh.corners());
  const Fairing_patch patch(framed, is_in_region, function);
  Fairing_report report;
  report.free_vertices = patch.size();
  Points f = patch.mesh().positions();
  report.initial_energy = Bending_energy(patch, f).value();
  report.initial_normal_jump = normal_jump(patch, f);
  if (options.exact_conformal_class) {
    Class_fairing fairing(patch);
    take_steps(patch, fairing, options, go_further, f, report);
    const std::string fault = report.steps > 0 ? step_fault([&] { fairing.polish(f); }) : "";
    if (!fault.empty()) report.converged = false, report.message = fault;
  } else {
    Outline_fairing fairing(patch);
    f = fairing.start();
    take_steps(patch, fairing, options, go_further, f, report);
  }
  const Points moved = frame.from_frame(f);
  Points positions = mesh.positions();
  for (int k = 0; k < patch.size(); ++k) {
    const int v = patch.free_vertex(k);
    positions.col(patch.vertices()[static_cast<std::size_t>(v)]) = moved.col(v);
  }
  report.energy = Bending_energy(patch, f).value();
  report.normal_jump = normal_jump(patch, f);
  report.conformality = map_of_region(patch, f);
  return {std::move(positions), std::move(report)};
}

}  // namespace Conformal_geometry_processing
