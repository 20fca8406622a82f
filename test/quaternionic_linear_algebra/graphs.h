// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "support/random.h"

/// Graphs of all kinds, and what their orderings cost.
namespace cgp_test {

namespace CGP = Conformal_geometry_processing;

using Edges = std::vector<std::array<int, 2>>;

inline CGP::Sparse_pattern pattern_of(int n, const Edges& edges)
{
  std::vector<std::vector<int>> columns(at(n));
  for (const auto& e : edges) columns[at(std::min(e[0], e[1]))].push_back(std::max(e[0], e[1]));
  return *CGP::sparse_pattern(std::move(columns));
}

inline CGP::Sparse_pattern pattern_of(const Mesh_view& mesh)
{
  Edges edges;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    edges.push_back({mesh.ends(k)[0], mesh.ends(k)[1]});
  return pattern_of(mesh.size_of_vertices(), edges);
}

inline Edges path_edges(int n)
{
  Edges edges;
  for (int i = 0; i + 1 < n; ++i) edges.push_back({i, i + 1});
  return edges;
}

inline Edges clique_edges(int n)
{
  Edges edges;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < i; ++j) edges.push_back({i, j});
  return edges;
}

inline Edges binary_tree_edges(int n)
{
  Edges edges;
  for (int i = 1; i < n; ++i) edges.push_back({(i - 1) / 2, i});
  return edges;
}

inline Edges star_edges(int n)
{
  Edges edges;
  for (int i = 1; i < n; ++i) edges.push_back({0, i});
  return edges;
}

/// a x a vertices, number i + a j at (i, j)
inline Edges grid_edges(int a)
{
  Edges edges;
  for (int j = 0; j < a; ++j)
    for (int i = 0; i < a; ++i) {
      if (i + 1 < a) edges.push_back({i + a * j, i + 1 + a * j});
      if (j + 1 < a) edges.push_back({i + a * j, i + a * (j + 1)});
    }
  return edges;
}

inline Eigen::Matrix3Xd grid_positions(int a)
{
  Eigen::Matrix3Xd p(3, a * a);
  for (int k = 0; k < a * a; ++k) p.col(k) << k % a, k / a, 0;
  return p;
}

inline Edges random_edges(int n, int count, std::uint64_t seed)
{
  Random random(seed);
  Edges edges;
  while (static_cast<int>(edges.size()) < count) {
    const int i = random.below(n), j = random.below(n);
    if (i != j) edges.push_back({i, j});
  }
  return edges;
}

inline Eigen::Matrix3Xd random_positions(int n, std::uint64_t seed)
{
  Random random(seed);
  Eigen::Matrix3Xd p(3, n);
  for (int k = 0; k < n; ++k) p.col(k) = random.vector();
  return p;
}

struct Named_graph {
  std::string name;
  int size;
  Edges edges;
};

/// connected and not, sparse and dense, with and without isolated vertices, empty and large
inline std::vector<Named_graph> graphs_of_all_kinds()
{
  Edges two_paths = path_edges(300);
  for (const auto& e : path_edges(300)) two_paths.push_back({e[0] + 300, e[1] + 300});
  return {{"nothing", 0, {}},
          {"one vertex", 1, {}},
          {"one edge", 2, {{0, 1}}},
          {"isolated vertices", 700, {}},
          {"a path", 1000, path_edges(1000)},
          {"two paths", 600, two_paths},
          {"an edge among isolated vertices", 500, {{17, 400}}},
          {"a binary tree", 1023, binary_tree_edges(1023)},
          {"a star", 600, star_edges(600)},
          {"a grid", 900, grid_edges(30)},
          {"a clique", 300, clique_edges(300)},
          {"a sparse random graph", 800, random_edges(800, 1200, 1)},
          {"a dense random graph", 400, random_edges(400, 20000, 2)}};
}

}  // namespace cgp_test
