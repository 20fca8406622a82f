// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_QUASI_CONFORMAL_ERROR_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_QUASI_CONFORMAL_ERROR_H

#include <Conformal_geometry_processing/measure/Distribution.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <array>

namespace Conformal_geometry_processing {
namespace internal {

/// A triangle laid out in the plane, at (0, 0), (length, 0) and (x, y), y >= 0
struct Flat_triangle {
  double length, x, y;
};

Flat_triangle flattened(const Points& positions, const std::array<int, 3>& corners);

}  // namespace internal

/// \ingroup PkgMeasure
/// \brief Returns Q >= 1 for each face: the ratio of the singular values of the linear map between
/// the old and the new triangle, 1 if it is a similarity [CGP 5.8.1].
///
/// Infinite if the new triangle has area zero. First order in the edge length even for exactly
/// conformal maps; `length_cross_ratio_change()` is the discretely exact measure.
/// \param positions the new ones, 3 x |V|
Eigen::VectorXd quasi_conformal_errors(const Mesh_view& mesh, const Points& positions);

/// \ingroup PkgMeasure
/// Returns statistics of the quasi-conformal errors, weighted by the areas of the old faces
internal::Distribution quasi_conformal_error(const Mesh_view& mesh, const Points& positions);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/measure/quasi_conformal_error_impl.h>
#endif

#endif
