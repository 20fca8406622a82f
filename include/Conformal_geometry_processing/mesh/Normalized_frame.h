// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_NORMALIZED_FRAME_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_NORMALIZED_FRAME_H

#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief the coordinates in which all numerics run: the centre of the bounding box at the origin,
/// its half diagonal about 1.
///
/// The scale is a power of two, so that scaling there and back costs no digit, and surfaces that
/// differ by a power of two give the same bits. Nothing overflows for coordinates of 1e-300..1e300.
class Normalized_frame {
 public:
  /// \pre `positions` has a column, all are finite
  explicit Normalized_frame(const Points& positions)
  {
    const Eigen::Vector3d low = positions.rowwise().minCoeff();
    const Eigen::Vector3d high = positions.rowwise().maxCoeff();
    m_center = low / 2 + high / 2;
    const double radius = stable_norm(high / 2 - low / 2);
    m_exponent = radius > 0 ? std::ilogb(radius) : 0;
  }

  const Eigen::Vector3d& center() const { return m_center; }

  /// the length of the frame's unit in the units of the mesh
  double unit() const { return std::ldexp(1., m_exponent); }

  /// positions of the mesh in the frame
  Points to_frame(Points positions) const
  {
    positions.colwise() -= m_center;
    return scaled(std::move(positions), -m_exponent);
  }

  /// positions in the frame back to the mesh
  Points from_frame(Points positions) const
  {
    positions = scaled(std::move(positions), m_exponent);
    positions.colwise() += m_center;
    return positions;
  }

 private:
  static Points scaled(Points positions, int exponent)
  {
    for (Eigen::Index i = 0; i < positions.size(); ++i)
      positions.data()[i] = std::ldexp(positions.data()[i], exponent);
    return positions;
  }

  Eigen::Vector3d m_center;
  int m_exponent;
};

}  // namespace Conformal_geometry_processing

#endif
