// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Border_vertices.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace conformal::mpi {

Border_vertices::Border_vertices(const Distributed_mesh& mesh)
{
  const int own = mesh.own_vertices(), all = mesh.mesh().size_of_vertices();
  const auto is_before = [&](int v) { return v >= own && mesh.number(v) < mesh.ranges().begin(); };
  std::vector<bool> is_border(static_cast<std::size_t>(own), false);
  for (const auto& [i, j] : mesh.mesh().ends())
    for (const auto& [a, b] : {std::pair(i, j), std::pair(j, i)})
      if (a < own && is_before(b)) is_border[static_cast<std::size_t>(a)] = true;
  ranges = Ranges::of(static_cast<int>(std::count(is_border.begin(), is_border.end(), true)));
  Eigen::MatrixXd known = Eigen::MatrixXd::Constant(1, all, -1);
  int next = ranges.begin();
  for (int v = 0; v < own; ++v)
    if (is_border[static_cast<std::size_t>(v)]) known(0, v) = next++;
  mesh.update(known);
  for (int v = 0; v < all; ++v) numbers.push_back(static_cast<int>(known(0, v)));
  while (own + others_before < all && is_before(own + others_before)) ++others_before;
}

}  // namespace conformal::mpi
