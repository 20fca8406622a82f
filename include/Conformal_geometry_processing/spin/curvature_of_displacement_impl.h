// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CURVATURE_OF_DISPLACEMENT_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CURVATURE_OF_DISPLACEMENT_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/exterior_derivative.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/curvature_of_displacement.h>

#include <Eigen/Core>

#include <string>
#include <utility>

namespace Conformal_geometry_processing {

CGP_INLINE Curvature_potential curvature_of_displacement(const Mesh_view& mesh,
                                                         const Eigen::VectorXd& height)
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
  return Curvature_potential::on_vertices(std::move(rho));
}

}  // namespace Conformal_geometry_processing

#endif
