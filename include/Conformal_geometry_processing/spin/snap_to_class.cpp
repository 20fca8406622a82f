// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/snap_to_class.h>

#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

void require_edge_lengths(const Mesh_view& mesh, const std::string& function)
{
  require_manifold_components(mesh, function);
  refuse_if_any(
      mesh.size_of_edges(),
      [&](int k) { return mesh.position(mesh.ends(k)[0]) == mesh.position(mesh.ends(k)[1]); },
      [&](int k) { return name_of_edge(mesh, k); }, function, "#edge of length zero",
      "its ends have to be different points");
}

Class_snap_report snap_to_class(const Mesh_view& reference, Points& positions,
                                const Snap_options& options, Rim_directions rim)
{
  const Normalized_frame frame(positions);
  Points f = frame.to_frame(positions);
  Conformal_class conformal_class(reference);
  conformal_class.keep(std::move(rim));
  const Snap_report snap = conformal_class.snap(f, options);
  Class_snap_report report;
  report.converged = snap.converged;
  report.iterations = snap.iterations;
  report.factorizations = snap.factorizations;
  report.initial_length_cross_ratio = length_cross_ratio_change(reference, positions);
  Points moved = snap.iterations == 0 ? positions : frame.from_frame(std::move(f));
  const double diagonal = (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff()).norm();
  report.displacement = (moved - positions).norm() / std::sqrt(double(positions.cols())) / diagonal;
  report.length_cross_ratio = length_cross_ratio_change(reference, moved);
  positions = std::move(moved);
  return report;
}

/// gives spins the sizes that scale edges as in the class of a mesh, of which f is a member
inline void resize_spins(const Mesh_view& reference, const Points& f,
                         Quaternion_vector<double>& lambda)
{
  const Eigen::VectorXd u = Edge_scales(reference).nearest_scales(f);
  for (Eigen::Index v = 0; v < u.size(); ++v)
    lambda[v] = std::exp(u[v] / 2) / norm(lambda[v]) * lambda[v];
}

/// not converged where the surface is too degenerate for the matrix of a snap
inline Class_snap_report snapped(const Mesh_view& reference, const Boundary_condition& boundary,
                                 Points& f)
{
  Rim_directions rim;
  if (boundary.kind == Boundary_condition::Kind::directions)
    rim = Rim_directions({f, reference.corners()}, boundary.direction);
  try {
    return snap_to_class(reference, f, {}, std::move(rim));
  } catch (const Solver_error& error) {
    if (is_out_of_memory(error)) throw;
    return {};
  }
}

void move_to_class(const Framed_surface& domain, const Boundary_condition& boundary,
                   Spin_result& result)
{
  const Normalized_frame& frame = domain.frame();
  const Mesh_view reference =
      domain.is_mollified() ? simple_delaunay(domain.mesh()) : domain.mesh();
  Points f = frame.to_frame(result.positions);
  Class_snap_report snap = snapped(reference, boundary, f);
  if (snap) {
    resize_spins(reference, f, result.lambda);
    restore_area(domain.measured(), f, result.lambda);
    result.positions = frame.from_frame(f);
    f = frame.to_frame(result.positions);  // after rounding
    snap.length_cross_ratio = length_cross_ratio_change(reference, f);
    certify(domain.measured(), f, result.lambda, result.report);
  }
  result.report.exact_class = std::move(snap);
}

}  // namespace Conformal_geometry_processing::internal
