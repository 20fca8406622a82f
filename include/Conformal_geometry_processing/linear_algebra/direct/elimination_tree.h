// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief The graph of a Hermitian matrix after a permutation: for every column j its rows i > j,
/// in any order, with the position of the entry in the pattern.
struct Permuted_graph {
  struct Entry {
    int row;
    int source;  ///< position of the entry in the pattern, ~position if it is transposed there
  };

  std::vector<int> offsets;  ///< size + 1
  std::vector<Entry> entries;

  Permuted_graph(const Sparse_pattern& pattern, const std::vector<int>& new_of_old);

  /// Renumbers a graph
  /// \pre `place[i] > place[j]` for every row i of column j
  Permuted_graph(const Permuted_graph& graph, const std::vector<int>& place);

  int size() const { return static_cast<int>(offsets.size()) - 1; }
  const Entry* begin(int j) const { return entries.data() + offsets[at(j)]; }
  const Entry* end(int j) const { return entries.data() + offsets[at(j) + 1]; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  // for_each_entry(action) calls action(column, entry) for each entry; called twice, to count and
  // to fill
  template <class For_each>
  void fill(int columns, int count, For_each for_each_entry)
  {
    offsets.assign(at(columns) + 1, 0);
    entries.resize(at(count));
    for_each_entry([&](int j, const Entry&) { ++offsets[at(j) + 1]; });
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    std::vector<int> next(offsets.begin(), offsets.end() - 1);
    for_each_entry([&](int j, const Entry& e) { entries[at(next[at(j)]++)] = e; });
  }
};

/// \ingroup PkgLinearAlgebra
/// \brief The graph by rows: for every row i its columns j < i, ascending.
struct Graph_rows {
  std::vector<int> offsets;  ///< size + 1
  std::vector<int> columns;

  explicit Graph_rows(const Permuted_graph& graph);

  int size() const { return static_cast<int>(offsets.size()) - 1; }
  const int* begin(int i) const { return columns.data() + offsets[at(i)]; }
  const int* end(int i) const { return columns.data() + offsets[at(i) + 1]; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes the elimination tree: for each column of the Cholesky factor the row of its
/// first entry below the diagonal, -1 at the roots (Liu 1990). Almost O(entries).
std::vector<int> elimination_tree(const internal::Graph_rows& graph);

/// \ingroup PkgLinearAlgebra
/// \brief Returns 0, ..., n - 1 stably sorted by keys in [0, n]. O(n)
std::vector<int> sorted_by(const std::vector<int>& key);

/// \ingroup PkgLinearAlgebra
/// \brief Orders the nodes of a forest, children before parents and subtrees contiguously; the
/// heaviest sibling is last, next to the parent, so that their supernodes can be merged.
/// \param weight in [0, n]
std::vector<int> postorder(const std::vector<int>& parent, const std::vector<int>& weight);

/// \ingroup PkgLinearAlgebra
/// \brief Computes the number of entries in each column of the factor, including the diagonal
/// (Gilbert, Ng and Peyton 1994). Almost O(entries), without forming the factor.
/// \param parent the elimination tree of the graph
/// \pre the numbering is a postorder: descendants of j are the numbers just below j
std::vector<int> column_counts(const internal::Permuted_graph& graph,
                               const std::vector<int>& parent);

/// \ingroup PkgLinearAlgebra
/// Maximal width of a supernode: a panel of 64 quaternionic columns fits in the second-level cache
constexpr int max_supernode_width = 64;

namespace internal {

/// Groups columns with the same rows below: j and j + 1 if j + 1 is the parent of j, its only
/// child, and has one row less. Returns the first column of each group, and the number of columns
/// at the end.
std::vector<int> fundamental_supernodes(const std::vector<int>& parent,
                                        const std::vector<int>& count);

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Groups the columns of a Cholesky factor into supernodes, which are stored as dense
/// panels; returns the first column of each, and the number of columns at the end.
///
/// Merges fundamental supernodes with the parent that follows them as long as the additional zeros
/// pay off (Ashcraft and Grimes 1989), then divides them to `max_supernode_width`.
/// \param parent the elimination tree, numbered in postorder \param count `column_counts()`
std::vector<int> relaxed_supernodes(const std::vector<int>& parent, const std::vector<int>& count);

}  // namespace Conformal_geometry_processing
