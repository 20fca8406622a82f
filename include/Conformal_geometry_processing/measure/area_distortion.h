// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_AREA_DISTORTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_AREA_DISTORTION_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// Returns the factor by which the map scales lengths, sqrt(new area / old area), for each face
/// \param positions the new ones, 3 x |V|
Eigen::VectorXd length_scales(const Mesh_view& mesh, const Points& positions);

namespace internal {

/// \ingroup PkgMeasure
/// Measures of the area distortion of a map
struct Area_distortion {
  double min_scale = 1, max_scale = 1;  ///< range of `length_scales()`
  double log_deviation = 0;  ///< standard deviation of the log of the scale, weighted by area
  /// share of the old area that shrank below a tenth of the root mean square scale, or of the new
  /// area that grew beyond ten times it, whichever is larger: the same for the inverse map
  double collapsed_share = 0;
};

}  // namespace internal

/// \ingroup PkgMeasure
/// Computes the area distortion from the mesh to the new positions
internal::Area_distortion area_distortion(const Mesh_view& mesh, const Points& positions);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/measure/area_distortion_impl.h>
#endif

#endif
