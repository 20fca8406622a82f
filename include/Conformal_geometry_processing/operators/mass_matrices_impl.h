// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_MASS_MATRICES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_MASS_MATRICES_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <cstddef>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::VectorXd face_areas(const Surface_ref& surface)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.size_of_faces());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    areas[sheet.face] += sheet.share * sheet.area;
  }
  return areas;
}

CGP_INLINE Eigen::VectorXd vertex_areas(const Surface_ref& surface)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.size_of_vertices());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    for (const int v : sheet.corners) areas[v] += sheet.share * sheet.area / 3;
  }
  return areas;
}

CGP_INLINE Eigen::VectorXd voronoi_areas(const Surface_ref& surface)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.size_of_vertices());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    const auto& e = sheet.vectors;
    Eigen::Vector3d inner;  // <edge, edge> at corner c, negative if obtuse
    for (int c = 0; c < 3; ++c) inner[c] = -e.col((c + 1) % 3).dot(e.col((c + 2) % 3));
    const bool is_obtuse = inner.minCoeff() < 0;
    for (int c = 0; c < 3; ++c) {
      const int a = (c + 1) % 3, b = (c + 2) % 3;
      areas[sheet.corners[static_cast<std::size_t>(c)]] +=
          sheet.share *
          (is_obtuse ? sheet.area / (inner[c] < 0 ? 2 : 4)
                     : (e.col(a).squaredNorm() * inner[a] + e.col(b).squaredNorm() * inner[b]) /
                           (16 * sheet.area));
    }
  }
  return areas;
}

}  // namespace Conformal_geometry_processing

#endif
