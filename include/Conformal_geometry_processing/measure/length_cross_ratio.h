// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_LENGTH_CROSS_RATIO_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_LENGTH_CROSS_RATIO_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// \brief Returns the logarithm of the length cross-ratio l_il l_jk / (l_lj l_ki) of each interior
/// edge ij with the opposite vertices k (left) and l (right); zero at the boundary. |E| numbers.
///
/// Two meshes of the same connectivity are discretely conformally equivalent if and only if their
/// length cross-ratios agree; Moebius transformations of the vertices preserve them.
Eigen::VectorXd log_length_cross_ratios(const Mesh_view& mesh, const Points& positions);

namespace internal {

/// \ingroup PkgMeasure
/// Deviation of a map from discrete conformality; zero for Moebius transformations
struct Length_cross_ratio_change {
  double rms = 0;  ///< over the interior edges
  double max = 0;  ///< absolute
};

}  // namespace internal

/// \ingroup PkgMeasure
/// Returns the change of the log length cross-ratios from the mesh to the new positions, 3 x |V|
internal::Length_cross_ratio_change length_cross_ratio_change(const Mesh_view& mesh,
                                                              const Points& positions);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/measure/length_cross_ratio_impl.h>
#endif

#endif
