// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/normals.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

Points face_normals(const Mesh_view& mesh)
{
  Points normals(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    normals.col(f) = stable_normalized(mesh.double_area_vector(f));
  return normals;
}

double corner_angle(const Sheet& sheet, int c)
{
  const Eigen::Vector3d a = sheet.vectors.col((c + 2) % 3), b = -sheet.vectors.col((c + 1) % 3);
  return std::atan2(2 * sheet.area, a.dot(b));
}

Points vertex_normals(const Surface_ref& surface, internal::Normal_weight weight)
{
  Points normals = Points::Zero(3, surface.size_of_vertices());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    const Eigen::Vector3d e = sheet.vectors.col(0), a = e.cross(sheet.vectors.col(1)),
                          n = stable_normalized(a);
    for (int c = 0; c < 3; ++c) {
      auto sum = normals.col(sheet.corners[static_cast<std::size_t>(c)]);
      switch (weight) {
        case internal::Normal_weight::area:
          sum += sheet.share * a;
          break;
        case internal::Normal_weight::angle:
          sum += sheet.share * corner_angle(sheet, c) * n;
          break;
        case internal::Normal_weight::uniform:
          sum += sheet.share * n;
          break;
      }
    }
  }
  for (Eigen::Index v = 0; v < normals.cols(); ++v)
    normals.col(v) = stable_normalized(normals.col(v));
  return normals;
}

}  // namespace Conformal_geometry_processing
