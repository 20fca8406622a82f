// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgCurves
/// \brief Normalized coordinates of curve flows: `Normalized_frame` in the plane, which makes
/// results independent of the unit of length and of a distant origin.
class Curve_frame {
 public:
  /// \pre `points` is not empty and finite
  explicit Curve_frame(const Plane_points& points) : m_frame(in_space(points)) {}

  /// The unit of the frame in units of the curve, a power of two
  double unit() const { return m_frame.unit(); }

  Plane_points to_frame(const Plane_points& points) const;

  /// Transforms points from the frame to the curve, in the memory of `result`
  void from_frame(const Plane_points& points, Plane_points& result) const;

 private:
  static Points in_space(const Plane_points& points);

  Normalized_frame m_frame;
};

}  // namespace Conformal_geometry_processing::internal
