// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/curvature_difference.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

Curvature_potential curvature_difference(const Mesh_view& mesh, const Points& positions)
{
  if (positions.cols() != mesh.size_of_vertices())
    throw Precondition_error("curvature_difference", std::to_string(positions.cols()) +
                                                         " positions, one per vertex is needed: " +
                                                         std::to_string(mesh.size_of_vertices()));
  const internal::Normalized_frame frame(mesh.positions());
  const Mesh_view before = internal::in_own_frame(mesh);
  Mesh_view after = before;
  after.set_positions(internal::Normalized_frame(positions).to_frame(positions));
  const Eigen::VectorXd change =
      mean_curvature_half_density(after) - mean_curvature_half_density(before);
  return Curvature_potential::on_vertices(
      change.cwiseQuotient(frame.unit() * voronoi_areas(before).cwiseSqrt()));
}

Curvature_potential transferred(const Curvature_potential& rho, const Mesh_view& from,
                                const Mesh_view& to)
{
  const double unit = internal::Normalized_frame(from.positions()).unit() /
                      internal::Normalized_frame(to.positions()).unit();
  const auto areas = [&rho](const Mesh_view& mesh) -> Eigen::VectorXd {
    const Mesh_view own = internal::in_own_frame(mesh);
    return rho.on == Curvature_potential::On::faces ? face_areas(own) : voronoi_areas(own);
  };
  const Eigen::VectorXd shrinking = areas(from).cwiseQuotient(areas(to)).cwiseSqrt();
  return {rho.on, unit * rho.values.cwiseProduct(shrinking)};
}

}  // namespace Conformal_geometry_processing
