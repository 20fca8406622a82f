// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Curvature_filter.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/painting/image_filters.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgFlow
/// options of `filtered_on_surface()`
struct Filter_options {
  double weight = 0.01;  ///< sigma > 0, on the surface scaled to the area 4 pi: features larger
                         ///< than about sigma^(1/(2 order)) count as large
  int order = 1;         ///< k >= 0, the sharpness of the cut-off
  double amount = 1;     ///< of `Curvature_band::unsharp`
};

}  // namespace internal

/// \ingroup PkgFlow
/// \brief filters a function on the vertices, such as rho or a height, by its frequencies on the
/// surface: the high part of an eigenfunction of the Laplacian with eigenvalue l is its share h =
/// sigma l^k / (1 + sigma l^k), see `Curvature_filter`; low-pass is (id + sigma Delta^k)^-1.
/// \param v |V| numbers
/// \pre `require_surface(mesh)` holds
/// \throw Precondition_error if weight or order are out of range
/// \throw Solver_error if a factorization fails
inline Eigen::VectorXd filtered_on_surface(const Mesh_view& mesh, const Eigen::VectorXd& v,
                                           Curvature_band band,
                                           const internal::Filter_options& options = {},
                                           const Spin_solvers& solvers = {})
{
  const Points& positions = mesh.positions();
  const Mesh_view in_frame(internal::Normalized_frame(positions).to_frame(positions),
                           mesh.corners());
  const internal::Curvature_filter filter(in_frame, options.weight, options.order, solvers);
  return band_of(v, filter(v), band, options.amount);
}

}  // namespace Conformal_geometry_processing
