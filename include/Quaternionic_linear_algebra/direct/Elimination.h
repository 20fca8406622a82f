// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

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
/// \param parent the elimination tree of the graph \param post a postorder of it
std::vector<int> column_counts(const internal::Permuted_graph& graph,
                               const std::vector<int>& parent, const std::vector<int>& post);

namespace internal {

/// \brief What is known of a factor before its rows are: enough to compare orderings.
///
/// Columns are numbered in a postorder of the elimination tree. Almost O(entries).
class Elimination {
 public:
  /// \param order a fill-reducing ordering of the vertices
  /// \param kept number of trailing vertices that are not eliminated, and keep their order
  Elimination(const Sparse_pattern& pattern, const Ordering& order, int kept = 0);

  /// The ordering refined to a postorder: `order()[k]` is the vertex eliminated as the k-th
  const Ordering& order() const { return m_order; }

  int size_of_columns() const { return static_cast<int>(m_order.size()); }
  int size_of_kept() const { return size_of_columns() - static_cast<int>(m_parent.size()); }

  /// The matrix in this order
  const Permuted_graph& graph() const { return m_graph; }

  /// The elimination tree and the entries in each column, of the columns that are eliminated
  const std::vector<int>& parent() const { return m_parent; }
  const std::vector<int>& count() const { return m_count; }

  /// Number of scalars in the factor
  std::int64_t factor_entries() const;

  /// Multiply-adds of scalars in one factorization: the sum of the squares of the column counts
  double operations() const;

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  void chain_kept(int kept);
  void renumber(const std::vector<int>& post);
  void cut_kept(int kept);

  Ordering m_order;
  Permuted_graph m_graph;
  std::vector<int> m_parent, m_count;
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
