// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/curvature_of_displacement.h>

#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <string>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// M_V^-1 B^T M_F B rho: the means of rho on faces, averaged around vertices
Eigen::VectorXd averaged_over_faces(const Mesh_view& mesh, const Eigen::VectorXd& rho)
{
  const Eigen::VectorXd areas = face_areas(mesh);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(rho.size());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    double mean = 0;
    for (const int v : mesh.corners(f)) mean += rho[v] / 3;
    for (const int v : mesh.corners(f)) sums[v] += areas[f] * mean / 3;
  }
  return sums.cwiseQuotient(vertex_areas(mesh));
}

}  // namespace internal

Curvature_potential curvature_of_displacement(const Mesh_view& mesh, const Eigen::VectorXd& height)
{
  if (height.size() != mesh.size_of_vertices())
    throw Precondition_error(
        "curvature_of_displacement",
        std::to_string(height.size()) +
            " heights, one per vertex is needed: " + std::to_string(mesh.size_of_vertices()));
  const Eigen::VectorXd slope = exterior_derivative_0(mesh) * height;
  const Eigen::VectorXd Lh = codifferential(mesh, cotan_weights(mesh), slope);
  Eigen::VectorXd rho = Lh.cwiseQuotient(2 * vertex_areas(mesh));
  internal::fill_unknown(mesh, boundary_vertices(mesh), rho);
  // The equation sees the means of rho on faces only. They are lower than the peaks that a bump of
  // a few edges has; a step of Richardson's iteration against the averaging makes up for that.
  rho += rho - internal::averaged_over_faces(mesh, rho);
  internal::fill_unknown(mesh, boundary_vertices(mesh), rho);
  return Curvature_potential::on_vertices(std::move(rho));
}

}  // namespace Conformal_geometry_processing
