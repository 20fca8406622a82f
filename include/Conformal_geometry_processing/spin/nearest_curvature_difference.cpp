// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/nearest_curvature_difference.h>

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>

#include <utility>

namespace Conformal_geometry_processing {

Curvature_potential nearest_curvature_difference(const Mesh_view& mesh, const Points& positions,
                                                 double distance_tolerance,
                                                 const Dirac_options& options,
                                                 const internal::Go_further& go_further,
                                                 const std::string& function)
{
  Nearest_spin_options own;
  own.direction = {0, 0, 1};
  own.distance_tolerance = distance_tolerance;
  Nearest_spin_transformation search(mesh, positions, function, own);
  Nearest_spin_result found = search.transform(options, go_further);
  const bool has_binormals = topology(mesh).is_closed() || found.direction == own.direction;
  if (found.report && found.distance < found.source_distance && has_binormals)
    return std::move(found.rho);
  return curvature_difference(mesh, positions);
}

}  // namespace Conformal_geometry_processing
