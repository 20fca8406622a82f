// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PLACE_SIDE_BY_SIDE_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PLACE_SIDE_BY_SIDE_H

#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/parameterization/pack_in_rows.h>

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief moves the images of components in the plane so that their bounding boxes do not overlap:
/// see `pack_in_rows()`, with gaps of a hundredth of the largest extent.
/// \param z u + i v of each vertex of the mesh, finite
inline void place_side_by_side(const std::vector<Mesh_component>& components, Eigen::VectorXcd& z)
{
  Eigen::Matrix2Xd low(2, static_cast<Eigen::Index>(components.size())), size = low;
  for (std::size_t c = 0; c < components.size(); ++c) {
    const Eigen::VectorXcd image = z(components[c].vertices);
    const auto i = static_cast<Eigen::Index>(c);
    low.col(i) << image.real().minCoeff(), image.imag().minCoeff();
    size.col(i) << image.real().maxCoeff(), image.imag().maxCoeff();
    size.col(i) -= low.col(i);
  }
  if (components.empty()) return;
  const Eigen::Matrix2Xd corners = pack_in_rows(size, 0.01 * size.maxCoeff());
  for (std::size_t c = 0; c < components.size(); ++c) {
    const Eigen::Vector2d move =
        corners.col(static_cast<Eigen::Index>(c)) - low.col(static_cast<Eigen::Index>(c));
    for (const int v : components[c].vertices) z[v] += std::complex<double>(move.x(), move.y());
  }
}

}  // namespace Conformal_geometry_processing

#endif
