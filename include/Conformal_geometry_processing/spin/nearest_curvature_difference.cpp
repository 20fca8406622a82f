// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/nearest_curvature_difference.h>

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>
#include <Conformal_geometry_processing/spin/turned_binormals.h>

#include <Eigen/Core>

#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

/// as blends transform
Spin_transformation_options options_of_blends(const Mesh_view& mesh, const Points& wanted)
{
  Spin_transformation_options options;
  if (topology(mesh).is_closed()) return options;
  const Mesh_view aligned(align(wanted, mesh.positions()).apply(wanted), mesh.corners());
  options.boundary = Boundary_condition::binormals(turned_binormals(mesh, aligned, mesh, 1));
  options.exactness.reset();
  return options;
}

/// \brief rho changed so that transformations by it arrive: the spins of a fit are no eigenvector
/// of its rho. The difference of curvature misses a surface by O(h^2), and corrections by as much
/// of themselves, so that each of the few is far smaller than the last one; but on nearly round
/// spheres these do not see the inversions of space, which hardly change curvature there.
Curvature_potential corrected(const Mesh_view& mesh, Curvature_potential rho, const Points& wanted,
                              double tolerance, const Dirac_options& options,
                              const Go_further& go_further)
{
  const int max_corrections = 6;
  Spin_transformation transformation(mesh, options_of_blends(mesh, wanted));
  const Eigen::VectorXd curvature = curvature_difference(mesh, wanted).values;
  Curvature_potential best = rho;
  for (double least = std::numeric_limits<double>::infinity(), i = 0; i < max_corrections; ++i) {
    const Spin_result r = transformation.transform(rho, options, go_further);
    if (!r.report.converged || r.report.cancelled) break;
    const double distance = align(r.positions, wanted).rms;
    if (!(distance < least)) break;
    const bool is_slow = distance > .9 * least;
    least = distance;
    best = rho;
    if (distance <= tolerance || is_slow) break;
    rho.values += curvature - curvature_difference(mesh, r.positions).values;
  }
  return best;
}

}  // namespace internal

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
    return internal::corrected(mesh, std::move(found.rho), found.positions, distance_tolerance,
                               options, go_further);
  return curvature_difference(mesh, positions);
}

}  // namespace Conformal_geometry_processing
