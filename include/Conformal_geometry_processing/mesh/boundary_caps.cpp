// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/boundary_caps.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

std::vector<int> boundary_caps(const internal::Intrinsic_triangulation& triangles)
{
  const double greatest_angle = 5 * std::acos(-1.) / 6;
  std::vector<int> caps(static_cast<std::size_t>(triangles.size_of_faces()), -1), waiting;
  for (int h = 0; h < triangles.size_of_halfedges(); ++h)
    if (triangles.twin(h) < 0) waiting.push_back(h);
  while (!waiting.empty()) {
    const int h = waiting.back();
    waiting.pop_back();
    int& cap = caps[static_cast<std::size_t>(h / 3)];
    if (cap >= 0 || !(triangles.angle(h) > greatest_angle)) continue;
    cap = h;
    for (const int side : {Mesh_view::next_in_face(h), Mesh_view::previous_in_face(h)})
      if (triangles.twin(side) >= 0) waiting.push_back(triangles.twin(side));
  }
  return caps;
}

}  // namespace Conformal_geometry_processing
