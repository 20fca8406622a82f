// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "support/handlebodies.h"

namespace cgp_test {

Mesh_view holed_block(int genus)
{
  std::set<std::array<int, 3>> cubes;
  for (int i = 0; i <= 2 * genus; ++i)
    for (int j = 0; j < 3; ++j)
      if (j != 1 || i % 2 == 0) cubes.insert({i, j, 0});
  return surface_of_cubes(cubes);
}

Mesh_view smoothed(const Mesh_view& mesh, int times)
{
  Points p = mesh.positions();
  for (int i = 0; i < times; ++i) {
    Points sum = p;
    Eigen::RowVectorXd count = Eigen::RowVectorXd::Ones(p.cols());
    for (int k = 0; k < mesh.size_of_edges(); ++k)
      for (int end = 0; end < 2; ++end) {
        sum.col(mesh.ends(k)[at(end)]) += p.col(mesh.ends(k)[at(1 - end)]);
        count[mesh.ends(k)[at(end)]] += 1;
      }
    p = sum.array().rowwise() / count.array();
  }
  return {std::move(p), mesh.corners()};
}

Mesh_view smooth_handlebody(int genus, int level)
{
  Mesh_view mesh = holed_block(genus);
  for (int i = 0; i < level; ++i) mesh = smoothed(subdivided(mesh), 3);
  return scaled_to_area(mesh, 4 * pi);
}

}  // namespace cgp_test
