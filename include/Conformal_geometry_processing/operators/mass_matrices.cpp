// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <cstddef>

namespace Conformal_geometry_processing {

Eigen::VectorXd face_areas(const Surface_ref& surface)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.size_of_faces());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    areas[sheet.face] += sheet.share * sheet.area;
  }
  return areas;
}

Eigen::VectorXd vertex_areas(const Surface_ref& surface)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.size_of_vertices());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    for (const int v : sheet.corners) areas[v] += sheet.share * sheet.area / 3;
  }
  return areas;
}

Eigen::VectorXd voronoi_areas(const Surface_ref& surface)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(surface.size_of_vertices());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    const Eigen::Vector3d cot(cotangent(sheet, 0), cotangent(sheet, 1), cotangent(sheet, 2));
    const bool is_obtuse = cot.minCoeff() < 0;
    const Eigen::RowVector3d part =  // next to each edge; a fourth power of lengths would overflow
        sheet.vectors.colwise().squaredNorm().cwiseProduct(cot.transpose()) / 8;
    for (int c = 0; c < 3; ++c)
      areas[sheet.corners[static_cast<std::size_t>(c)]] +=
          sheet.share * (is_obtuse ? sheet.area / (cot[c] < 0 ? 2 : 4) : part.sum() - part[c]);
  }
  return areas;
}

}  // namespace Conformal_geometry_processing
