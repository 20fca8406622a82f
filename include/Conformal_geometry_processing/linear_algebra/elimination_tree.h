// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_ELIMINATION_TREE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_ELIMINATION_TREE_H

#include <Conformal_geometry_processing/algebra/Sparse_pattern.h>
#include <Conformal_geometry_processing/linear_algebra/Ordering.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the graph of a Hermitian matrix after a permutation: for every row i its neighbours j <
/// i, ascending, with the position of the entry in the pattern.
struct Permuted_graph {
  struct Neighbour {
    int column;  ///< j < i
    int source;  ///< position of the entry in the pattern, ~position if it stands transposed there
  };

  std::vector<int> offsets;  ///< size + 1
  std::vector<Neighbour> neighbours;

  Permuted_graph(const Sparse_pattern& pattern, const std::vector<int>& new_of_old)
      : offsets(new_of_old.size() + 1, 0)
  {
    const auto visit = [&](auto action) {
      for (std::size_t j = 0; j + 1 < pattern.offsets.size(); ++j)
        for (int k = pattern.offsets[j] + 1; k < pattern.offsets[j + 1]; ++k) {
          const int a = new_of_old[static_cast<std::size_t>(pattern.indices[index(k)])];
          const int b = new_of_old[j];
          action(std::max(a, b), Neighbour{std::min(a, b), a > b ? k : ~k});
        }
    };
    visit([&](int i, const Neighbour&) { ++offsets[index(i) + 1]; });
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    neighbours.resize(index(offsets.back()));
    std::vector<int> next(offsets.begin(), offsets.end() - 1);
    visit([&](int i, const Neighbour& n) { neighbours[index(next[index(i)]++)] = n; });
    for (int i = 0; i < size(); ++i)
      std::sort(begin(i), end(i),
                [](const Neighbour& a, const Neighbour& b) { return a.column < b.column; });
  }

  int size() const { return static_cast<int>(offsets.size()) - 1; }
  Neighbour* begin(int i) { return neighbours.data() + offsets[index(i)]; }
  Neighbour* end(int i) { return neighbours.data() + offsets[index(i) + 1]; }
  const Neighbour* begin(int i) const { return neighbours.data() + offsets[index(i)]; }
  const Neighbour* end(int i) const { return neighbours.data() + offsets[index(i) + 1]; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
};

/// \ingroup PkgLinearAlgebra
/// \brief the elimination tree: for each column of the Cholesky factor the row of its first entry
/// below the diagonal, -1 at the roots (Liu 1990). Almost O(entries).
inline std::vector<int> elimination_tree(const Permuted_graph& graph)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> parent(at(graph.size()), -1), ancestor(parent);
  for (int i = 0; i < graph.size(); ++i)
    for (const auto* n = graph.begin(i); n != graph.end(i); ++n)
      for (int j = n->column; j != -1 && j < i;) {
        const int up = ancestor[at(j)];
        ancestor[at(j)] = i;  // path compression
        if (up == -1) parent[at(j)] = i;
        j = up;
      }
  return parent;
}

/// \ingroup PkgLinearAlgebra
/// \brief the nodes of a forest, children before parents and subtrees together; among siblings the
/// lightest first, so that what waits for the heaviest subtree is small.
inline std::vector<int> postorder(const std::vector<int>& parent, const std::vector<int>& weight)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int n = static_cast<int>(parent.size());
  std::vector<int> by_weight(parent.size());
  std::iota(by_weight.begin(), by_weight.end(), 0);
  std::stable_sort(by_weight.begin(), by_weight.end(),
                   [&](int a, int b) { return weight[at(a)] > weight[at(b)]; });
  std::vector<int> child(parent.size(), -1), sibling(parent.size(), -1), order, path;
  for (int j : by_weight)  // the lightest ends up at the head of its list
    if (parent[at(j)] >= 0) {
      sibling[at(j)] = child[at(parent[at(j)])];
      child[at(parent[at(j)])] = j;
    }
  order.reserve(parent.size());
  for (int root = 0; root < n; ++root) {
    if (parent[at(root)] >= 0) continue;
    for (path.push_back(root); !path.empty();) {
      const int j = path.back(), c = child[at(j)];
      if (c >= 0) {
        child[at(j)] = sibling[at(c)];
        path.push_back(c);
      } else {
        order.push_back(j);
        path.pop_back();
      }
    }
  }
  return order;
}

/// \ingroup PkgLinearAlgebra
/// \brief the number of entries in each column of the factor, diagonal included (Gilbert, Ng and
/// Peyton 1994). Almost O(entries), without forming the factor.
/// \param parent the elimination tree of the graph
/// \pre the numbering is a postorder: descendants of j are the numbers just below j
inline std::vector<int> column_counts(const Permuted_graph& graph, const std::vector<int>& parent)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int n = graph.size();
  std::vector<int> first(at(n)), last_leaf(at(n), -1), set(at(n)), count(at(n), 0);
  std::iota(first.begin(), first.end(), 0);
  std::iota(set.begin(), set.end(), 0);
  std::vector<char> is_leaf(at(n), 1);
  for (int j = 0; j < n; ++j)
    if (parent[at(j)] >= 0) {
      first[at(parent[at(j)])] = std::min(first[at(parent[at(j)])], first[at(j)]);
      is_leaf[at(parent[at(j)])] = 0;
    }
  const auto find = [&](int j) {
    while (set[at(j)] != j) j = set[at(j)] = set[at(set[at(j)])];
    return j;
  };
  // Row i of the factor is a subtree with root i; its columns number as many as its leaves cover.
  // The neighbours of i that are leaves come in ascending order when columns are swept.
  std::vector<int> offsets(at(n) + 1, 0);
  for (const auto& e : graph.neighbours) ++offsets[at(e.column) + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> rows(graph.neighbours.size()), next(offsets.begin(), offsets.end() - 1);
  for (int i = 0; i < n; ++i)
    for (const auto* e = graph.begin(i); e != graph.end(i); ++e)
      rows[at(next[at(e->column)]++)] = i;
  for (int j = 0; j < n; ++j) {
    count[at(j)] += is_leaf[at(j)];
    if (parent[at(j)] >= 0) --count[at(parent[at(j)])];
    for (int k = offsets[at(j)]; k < offsets[at(j) + 1]; ++k) {
      int& leaf = last_leaf[at(rows[at(k)])];
      if (leaf >= first[at(j)]) continue;  // a descendant of j is a neighbour too: j is no leaf
      ++count[at(j)];
      if (leaf >= 0) --count[at(find(leaf))];  // counted twice from the common ancestor upward
      leaf = j;
    }
    if (parent[at(j)] >= 0) set[at(j)] = parent[at(j)];
  }
  for (int j = 0; j < n; ++j)
    if (parent[at(j)] >= 0) count[at(parent[at(j)])] += count[at(j)];
  return count;
}

}  // namespace Conformal_geometry_processing

#endif
