// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/polyhedra.h"

namespace cgp_test {

Mesh_view tetrahedron()
{
  return {points({{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}),
          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
}

Mesh_view surface_of_cubes(const std::set<std::array<int, 3>>& cubes)
{
  std::map<std::array<int, 3>, int> number;
  std::vector<std::array<double, 3>> list;
  Corners corners;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = number.insert({p, static_cast<int>(list.size())});
    if (is_new) list.push_back({double(p[0]), double(p[1]), double(p[2])});
    return it->second;
  };
  for (const auto& cube : cubes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        std::array<int, 3> neighbour = cube;
        neighbour[axis] += side == 0 ? -1 : 1;
        if (cubes.count(neighbour)) continue;
        const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
        std::array<int, 4> square;
        for (std::size_t c = 0; c < 4; ++c) {
          std::array<int, 3> p = cube;
          p[axis] += side;
          p[a] += c == 1 || c == 2;
          p[b] += c >= 2;
          square[c] = vertex(p);
        }
        if (side == 0) std::swap(square[1], square[3]);
        add_square(corners, cube[0] + cube[1], cube[2], square[0], square[1], square[2], square[3]);
      }
  return {points(list), std::move(corners)};
}

Mesh_view block(int nx, int ny, int nz)
{
  std::set<std::array<int, 3>> cubes;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j)
      for (int k = 0; k < nz; ++k) cubes.insert({i, j, k});
  return surface_of_cubes(cubes);
}

Mesh_view cube()
{
  return block(1, 1, 1);
}

Mesh_view double_torus()
{
  std::set<std::array<int, 3>> cubes;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 3; ++j)
      if (j != 1 || i % 2 == 0) cubes.insert({i, j, 0});
  return surface_of_cubes(cubes);
}

}  // namespace cgp_test
