// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing::internal {

/// \brief Normalized coordinates for all numerical computations: the centre of the bounding box is
/// the origin, half its diagonal is about 1.
///
/// The scale is a power of two, so that scaling is exact, and surfaces that differ by a power of
/// two give bitwise the same results. No overflow for coordinates of 1e-300..1e300.
class Normalized_frame {
 public:
  /// \pre `positions` is not empty and finite
  explicit Normalized_frame(const Points& positions);

  const Eigen::Vector3d& center() const { return m_center; }

  /// The unit of the frame in units of the mesh
  double unit() const { return std::ldexp(1., m_exponent); }

  /// Transforms positions from the mesh to the frame
  Points to_frame(Points positions) const;

  /// Transforms positions from the frame to the mesh
  Points from_frame(Points positions) const;

 private:
  static Points scaled(Points positions, int exponent);

  Eigen::Vector3d m_center;
  int m_exponent;
};

/// \brief Returns the mesh in its `Normalized_frame`: of moderate size, where products of areas and
/// volumes neither overflow nor underflow.
/// \pre the mesh has vertices, with finite coordinates
Mesh_view in_own_frame(Mesh_view mesh);

}  // namespace Conformal_geometry_processing::internal
