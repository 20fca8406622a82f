// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <utility>

namespace Conformal_geometry_processing {

internal::Normalized_frame::Normalized_frame(const Points& positions)
{
  const Eigen::Vector3d low = positions.rowwise().minCoeff();
  const Eigen::Vector3d high = positions.rowwise().maxCoeff();
  m_center = low / 2 + high / 2;
  const double radius = stable_norm(high / 2 - low / 2);
  m_exponent = radius > 0 ? std::ilogb(radius) : 0;
}

Points internal::Normalized_frame::to_frame(Points positions) const
{
  positions.colwise() -= m_center;
  return scaled(std::move(positions), -m_exponent);
}

Points internal::Normalized_frame::from_frame(Points positions) const
{
  positions = scaled(std::move(positions), m_exponent);
  positions.colwise() += m_center;
  return positions;
}

Points internal::Normalized_frame::scaled(Points positions, int exponent)
{
  for (Eigen::Index i = 0; i < positions.size(); ++i)
    positions.data()[i] = std::ldexp(positions.data()[i], exponent);
  return positions;
}

Mesh_view internal::in_own_frame(Mesh_view mesh)
{
  mesh.set_positions(Normalized_frame(mesh.positions()).to_frame(mesh.positions()));
  return mesh;
}

}  // namespace Conformal_geometry_processing
