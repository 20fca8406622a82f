// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Elimination.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Conformal_geometry_processing {

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

namespace internal {

/// \brief Symbolic part of a supernodal Cholesky factorization, which depends on the pattern only;
/// computed once for the graph of a mesh and shared by its real and its quaternionic matrices.
///
/// A supernode is a range of columns with a common list of rows below it. Its front is the dense
/// lower triangle of its columns followed by these rows. Columns are numbered in a postorder of the
/// elimination tree. O(entries + rows of the supernodes).
///
/// Vertices at the end of the order may be *kept*: they are not eliminated, belong to no supernode
/// and have no entries between them; they occur as rows below supernodes only. Supernodes without a
/// parent then leave an update to the kept vertices; the sum of these updates is the contribution
/// of the elimination to their Schur complement.
class Supernodal_structure {
 public:
  /// Position of a matrix entry: the row in the front, the column in the panel
  struct Entry {
    int source;  ///< position in the pattern, ~position if conjugated
    unsigned row : 26, column : 6;
  };

  Supernodal_structure(const Sparse_pattern& pattern, const Elimination& elimination);

  /// \param order, kept see `Elimination`
  Supernodal_structure(const Sparse_pattern& pattern, const Ordering& order, int kept = 0)
      : Supernodal_structure(pattern, Elimination(pattern, order, kept))
  {}

  int size_of_columns() const { return static_cast<int>(m_order.size()); }
  int size_of_kept() const { return m_kept; }
  int size() const { return static_cast<int>(m_first.size()) - 1; }  ///< number of supernodes

  const Ordering& order() const { return m_order; }  ///< of the elimination

  int first(int s) const { return m_first[at(s)]; }
  int width(int s) const { return m_first[at(s) + 1] - m_first[at(s)]; }
  int height(int s) const;
  int parent(int s) const { return m_parent[at(s)]; }
  int depth(int s) const { return m_depth[at(s)]; }

  /// Rows below supernode s, ascending
  const int* rows(int s) const { return m_rows.data() + m_row_offsets[at(s)]; }

  /// Positions of these rows in the front of the parent
  const int* relative_rows(int s) const { return m_relative.data() + m_row_offsets[at(s)]; }

  /// Children of supernode s, in the order of elimination
  const int* children_begin(int s) const { return m_children.data() + m_child_offsets[at(s)]; }
  const int* children_end(int s) const { return m_children.data() + m_child_offsets[at(s) + 1]; }

  /// Entries of the matrix that belong to the panel of supernode s
  const Entry* entries_begin(int s) const { return m_entries.data() + m_entry_offsets[at(s)]; }
  const Entry* entries_end(int s) const { return m_entries.data() + m_entry_offsets[at(s) + 1]; }

  /// Number of scalars in the factor, without and with the explicit zeros of the supernodes
  std::int64_t factor_entries() const { return m_factor_entries; }
  std::int64_t stored_entries() const;

  /// Multiply-adds of scalars in one factorization
  double operations() const { return m_operations; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  void find_tree(const std::vector<int>& parent, const std::vector<int>& count);
  void find_rows(const Graph_rows& graph);
  void find_children();
  void find_places(const Permuted_graph& graph, const Sparse_pattern& pattern);
  void add_entry(int source, int row, int column);

  Ordering m_order;
  int m_kept;
  std::vector<int> m_first;      // size() + 1
  std::vector<int> m_supernode;  // of each column, -1 if it is kept
  std::vector<int> m_parent, m_depth, m_child_offsets, m_children;
  std::vector<std::int64_t> m_row_offsets;
  std::vector<int> m_rows, m_relative;
  std::vector<int> m_entry_offsets;
  std::vector<Entry> m_entries;
  std::int64_t m_factor_entries;
  double m_operations;
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
