// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

/// The structure of a Cholesky factor by the definition: eliminating a vertex joins its neighbours.
namespace cgp_test {

/// for every column j the rows i > j of the factor
using Factor_rows = std::vector<std::set<int>>;

inline Factor_rows eliminated(const CGP::Sparse_pattern& pattern,
                              const CGP::internal::Ordering& order)
{
  const std::vector<int> place = CGP::inverse_permutation(order);
  Factor_rows rows(order.size());
  for (int j = 0; j < pattern.size(); ++j)
    for (int k = pattern.offsets[at(j)] + 1; k < pattern.offsets[at(j) + 1]; ++k) {
      const int a = place[at(j)], b = place[at(pattern.indices[at(k)])];
      rows[at(std::min(a, b))].insert(std::max(a, b));
    }
  for (const std::set<int>& column : rows)
    for (int i : column)
      for (int above : column)
        if (above < i) rows[at(above)].insert(i);
  return rows;
}

inline std::vector<int> parents(const Factor_rows& rows)
{
  std::vector<int> parent;
  for (const std::set<int>& column : rows) parent.push_back(column.empty() ? -1 : *column.begin());
  return parent;
}

inline std::vector<int> counts(const Factor_rows& rows)
{
  std::vector<int> count;
  for (const std::set<int>& column : rows) count.push_back(static_cast<int>(column.size()) + 1);
  return count;
}

/// small graphs of all kinds, in random orders
struct Ordered_graph {
  std::string name;
  Pattern pattern;
  CGP::internal::Ordering order;
};

inline std::vector<Ordered_graph> ordered_graphs()
{
  std::vector<Ordered_graph> graphs;
  const auto add = [&](const std::string& name, const Pattern& pattern) {
    const int n = pattern->size();
    graphs.push_back({name, pattern, random_permutation(n, 40 + graphs.size())});
    graphs.push_back({name + " as numbered", pattern, random_permutation(n, 0)});
    std::iota(graphs.back().order.begin(), graphs.back().order.end(), 0);
  };
  add("one vertex", pattern_of_edges(1, {}));
  add("no edges", pattern_of_edges(7, {}));
  add("a path", pattern_of_edges(5, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}));
  add("a star", pattern_of_edges(6, {{3, 0}, {3, 1}, {3, 2}, {3, 4}, {3, 5}}));
  add("two triangles and a vertex",
      pattern_of_edges(7, {{0, 2}, {2, 4}, {4, 0}, {1, 3}, {3, 5}, {5, 1}}));
  add("a complete graph", full_pattern(9));
  add("a grid", grid_pattern(7, 9));
  for (const int n : {5, 20, 60, 150})
    add(std::to_string(n) + " vertices with chords", random_pattern(n, at(n)));
  return graphs;
}

}  // namespace cgp_test
