// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/well_shaped_faces.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

bool Face_height::operator<(const Face_height& other) const
{
  return std::pair(relative, face) < std::pair(other.relative, other.face);
}

Face_height face_height(const Mesh_view& mesh, int f)
{
  const double twice_area = mesh.double_area_vector(f).norm();
  double longest = 0;  // squared
  for (int h = 3 * f; h < 3 * f + 3; ++h)
    longest = (std::max)(longest, mesh.vector(h).squaredNorm());
  return {longest > 0 ? twice_area / longest : 0, twice_area, f};
}

}  // namespace internal

internal::Well_shaped_faces well_shaped_faces(const Mesh_view& mesh)
{
  const double least_height = 0.05, greatest_share = 0.05;
  std::vector<internal::Face_height> thin;
  double all = 0, left_out = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const internal::Face_height face = internal::face_height(mesh, f);
    all += face.twice_area;
    if (!(face.relative > least_height)) thin.push_back(face);
  }
  std::sort(thin.begin(), thin.end());
  std::vector<bool> is_sound(static_cast<std::size_t>(mesh.size_of_faces()), true);
  for (const internal::Face_height& face : thin) {
    if (left_out + face.twice_area > greatest_share * all) break;
    left_out += face.twice_area;
    is_sound[static_cast<std::size_t>(face.face)] = false;
  }
  Mesh_view::Corners corners;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    if (is_sound[static_cast<std::size_t>(f)]) corners.push_back(mesh.corners(f));
  return {{mesh.positions(), std::move(corners)}, 1 - left_out / all};
}

}  // namespace Conformal_geometry_processing
