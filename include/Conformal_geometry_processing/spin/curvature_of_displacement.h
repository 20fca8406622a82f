// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CURVATURE_OF_DISPLACEMENT_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CURVATURE_OF_DISPLACEMENT_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/divergence.h>
#include <Conformal_geometry_processing/operators/exterior_derivative.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <Eigen/Core>

#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the rho of a bump of height h along the normals, rho = Delta h / 2 with the positive
/// semidefinite Laplacian; on vertices, in 1/length [CGP 6.2, where the factor is missing].
///
/// A displacement by h N shears the surface as soon as h is not small; the spin transformation by
/// rho has a bump of much the same height, and does not. On planes and spheres H |df| changes by
/// rho |df| to first order in h; on other surfaces also by -(H^2 - K) h |df|, which is left out as
/// the displacement is not conformal there.
///
/// The Laplacian is M_V^-1 L, so that rho is exactly what the height is worth against every linear
/// function. At the boundary, where L h also holds the slope of h, rho is the mean of the interior
/// neighbours.
/// \param height |V| numbers, in the units of the mesh
/// \throw Precondition_error if their number is another
inline Curvature_potential curvature_of_displacement(const Mesh_view& mesh,
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
  internal::fill_boundary(mesh, rho);
  return Curvature_potential::on_vertices(std::move(rho));
}

}  // namespace Conformal_geometry_processing

#endif
