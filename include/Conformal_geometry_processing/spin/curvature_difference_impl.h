// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CURVATURE_DIFFERENCE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CURVATURE_DIFFERENCE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

CGP_INLINE Curvature_potential curvature_difference(const Mesh_view& mesh, const Points& positions)
{
  if (positions.cols() != mesh.size_of_vertices())
    throw Precondition_error("curvature_difference", std::to_string(positions.cols()) +
                                                         " positions, one per vertex is needed: " +
                                                         std::to_string(mesh.size_of_vertices()));
  const Mesh_view other(positions, mesh.corners());
  const Eigen::VectorXd change =
      mean_curvature_half_density(other) - mean_curvature_half_density(mesh);
  return Curvature_potential::on_vertices(change.cwiseQuotient(voronoi_areas(mesh).cwiseSqrt()));
}

CGP_INLINE Curvature_potential transferred(const Curvature_potential& rho, const Mesh_view& from,
                                           const Mesh_view& to)
{
  const Eigen::VectorXd shrinking =
      voronoi_areas(from).cwiseQuotient(voronoi_areas(to)).cwiseSqrt();
  return Curvature_potential::on_vertices(rho.values.cwiseProduct(shrinking));
}

}  // namespace Conformal_geometry_processing

#endif
