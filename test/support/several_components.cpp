// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/several_components.h"

namespace cgp_test {

Joined_meshes interleaved(const std::vector<Mesh_view>& parts)
{
  Joined_meshes all;
  all.vertices.resize(parts.size());
  all.faces.resize(parts.size());
  std::vector<Eigen::Vector3d> points;
  Corners corners;
  const auto in_turn = [&](auto size, auto take) {
    for (int i = 0, is_left = 1; is_left; ++i) {
      is_left = 0;
      for (std::size_t p = 0; p < parts.size(); ++p)
        if (i < size(parts[p])) {
          take(p, i);
          is_left = 1;
        }
    }
  };
  in_turn([](const Mesh_view& m) { return m.size_of_vertices(); },
          [&](std::size_t p, int v) {
            all.vertices[p].push_back(static_cast<int>(points.size()));
            points.emplace_back(parts[p].position(v));
          });
  in_turn([](const Mesh_view& m) { return m.size_of_faces(); },
          [&](std::size_t p, int f) {
            const auto& c = parts[p].corners(f);
            const auto& v = all.vertices[p];
            all.faces[p].push_back(static_cast<int>(corners.size()));
            corners.push_back({v[at(c[0])], v[at(c[1])], v[at(c[2])]});
          });
  Points p(3, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index i = 0; i < p.cols(); ++i) p.col(i) = points[static_cast<std::size_t>(i)];
  all.mesh = {std::move(p), std::move(corners)};
  return all;
}

Mesh_view moved(const Mesh_view& mesh, const Eigen::Vector3d& by)
{
  return {mesh.positions().colwise() + by, mesh.corners()};
}

std::vector<Mesh_view> surfaces_of_different_types()
{
  return {icosphere(2), moved(torus(1, 0.4, 18, 9), {4, 0, 1}),
          moved(scaled(cap_from_disk(jittered_disk(5, .3), 1), 3), {0, 9, 0})};
}

}  // namespace cgp_test
