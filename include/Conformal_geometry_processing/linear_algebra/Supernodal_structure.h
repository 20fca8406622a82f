// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SUPERNODAL_STRUCTURE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SUPERNODAL_STRUCTURE_H

#include <Conformal_geometry_processing/linear_algebra/elimination_tree.h>
#include <Conformal_geometry_processing/linear_algebra/supernodes.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief all of a supernodal Cholesky factorization that depends on the pattern alone; made once
/// for the graph of a mesh and shared by its real and its quaternionic matrices.
///
/// A supernode is a range of columns with a common list of rows below it. Its front is the dense
/// lower triangle of its columns followed by these rows. Columns are numbered in a postorder of the
/// elimination tree. O(entries + rows of the supernodes).
class Supernodal_structure {
 public:
  /// where an entry of the matrix goes: the row of the front, the column of the panel
  struct Entry {
    int source;  ///< position in the pattern, ~position if conjugated
    int row, column;
  };

  /// \param order a fill-reducing ordering of the vertices
  Supernodal_structure(const Sparse_pattern& pattern, const Ordering& order)
  {
    std::vector<int> parent, count;
    find_columns(pattern, order, parent, count);
    const Permuted_graph graph(pattern, inverse_permutation(m_order));
    m_first = relaxed_supernodes(parent, count);
    find_rows(graph);
    find_relative_rows();
    find_entries(graph, pattern);
  }

  int size_of_columns() const { return static_cast<int>(m_order.size()); }
  int size() const { return static_cast<int>(m_first.size()) - 1; }  ///< number of supernodes

  /// the ordering refined to a postorder: `order()[k]` is the vertex eliminated as the k-th
  const Ordering& order() const { return m_order; }

  int first(int s) const { return m_first[at(s)]; }
  int width(int s) const { return m_first[at(s) + 1] - m_first[at(s)]; }
  int height(int s) const
  {
    return static_cast<int>(m_row_offsets[at(s) + 1] - m_row_offsets[at(s)]);
  }
  int parent(int s) const { return m_parent[at(s)]; }
  int depth(int s) const { return m_depth[at(s)]; }

  /// the rows below supernode s, ascending
  const int* rows(int s) const { return m_rows.data() + m_row_offsets[at(s)]; }

  /// their places in the front of the parent
  const int* relative_rows(int s) const { return m_relative.data() + m_row_offsets[at(s)]; }

  /// the children of supernode s, in the order of elimination
  const int* children_begin(int s) const { return m_children.data() + m_child_offsets[at(s)]; }
  const int* children_end(int s) const { return m_children.data() + m_child_offsets[at(s) + 1]; }

  /// the entries of the matrix that belong to the panel of supernode s
  const Entry* entries_begin(int s) const { return m_entries.data() + m_entry_offsets[at(s)]; }
  const Entry* entries_end(int s) const { return m_entries.data() + m_entry_offsets[at(s) + 1]; }

  /// scalars in the factor, without and with the zeros that supernodes store
  std::int64_t factor_entries() const { return m_factor_entries; }
  std::int64_t stored_entries() const
  {
    std::int64_t sum = 0;
    for (int s = 0; s < size(); ++s)
      sum += static_cast<std::int64_t>(width(s)) * (width(s) + 1) / 2 +
             static_cast<std::int64_t>(width(s)) * height(s);
    return sum;
  }

  /// multiply-adds of scalars in one factorization: the sum of the squares of the column counts
  double operations() const { return m_operations; }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  void find_columns(const Sparse_pattern& pattern, const Ordering& order, std::vector<int>& parent,
                    std::vector<int>& count)
  {
    m_order = order;
    renumber(pattern, std::vector<int>(order.size(), 0), parent);
    count = column_counts(Permuted_graph(pattern, inverse_permutation(m_order)), parent);
    renumber(pattern, count, parent);
    const Permuted_graph graph(pattern, inverse_permutation(m_order));
    count = column_counts(graph, parent);
    for (int c : count) {
      m_factor_entries += c;
      m_operations += static_cast<double>(c) * c;
    }
  }

  // Refines the ordering to a postorder of its tree.
  void renumber(const Sparse_pattern& pattern, const std::vector<int>& weight,
                std::vector<int>& parent)
  {
    parent = elimination_tree(Permuted_graph(pattern, inverse_permutation(m_order)));
    const std::vector<int> post = postorder(parent, weight);
    const std::vector<int> place = inverse_permutation(post);
    Ordering order(post.size());
    std::vector<int> up(post.size());
    for (std::size_t k = 0; k < post.size(); ++k) {
      order[k] = m_order[at(post[k])];
      const int p = parent[at(post[k])];
      up[k] = p < 0 ? -1 : place[at(p)];
    }
    m_order = std::move(order);
    parent = std::move(up);
  }

  // Rows of a supernode: those of its entries and those of its children, less its own columns.
  void find_rows(const Permuted_graph& graph)
  {
    std::vector<int> supernode(at(size_of_columns())), mark(supernode.size(), -1);
    for (int s = 0; s < size(); ++s)
      std::fill(supernode.begin() + first(s), supernode.begin() + m_first[at(s) + 1], s);
    std::vector<int> offsets(supernode.size() + 1, 0), below(graph.neighbours.size());
    for (const auto& e : graph.neighbours) ++offsets[at(e.column) + 1];
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    std::vector<int> next(offsets.begin(), offsets.end() - 1);
    for (int i = 0; i < graph.size(); ++i)
      for (const auto* e = graph.begin(i); e != graph.end(i); ++e)
        below[at(next[at(e->column)]++)] = i;

    m_parent.assign(at(size()), -1);
    m_row_offsets.assign(1, 0);
    std::vector<int> last_child(at(size()), -1), previous_child(at(size()), -1);
    for (int s = 0; s < size(); ++s) {
      const int end = m_first[at(s) + 1];
      const auto add = [&](int i) {
        if (i < end || mark[at(i)] == s) return;
        mark[at(i)] = s;
        m_rows.push_back(i);
      };
      for (int k = offsets[at(first(s))]; k < offsets[at(end)]; ++k) add(below[at(k)]);
      for (int c = last_child[at(s)]; c >= 0; c = previous_child[at(c)])
        for (std::int64_t k = m_row_offsets[at(c)]; k < m_row_offsets[at(c) + 1]; ++k)
          add(m_rows[static_cast<std::size_t>(k)]);
      std::sort(m_rows.begin() + m_row_offsets.back(), m_rows.end());
      m_row_offsets.push_back(static_cast<std::int64_t>(m_rows.size()));
      if (height(s) == 0) continue;
      m_parent[at(s)] = supernode[at(rows(s)[0])];
      previous_child[at(s)] = last_child[at(parent(s))];
      last_child[at(parent(s))] = s;
    }
    find_children();
  }

  void find_children()
  {
    m_child_offsets.assign(at(size()) + 1, 0);
    for (int p : m_parent)
      if (p >= 0) ++m_child_offsets[at(p) + 1];
    std::partial_sum(m_child_offsets.begin(), m_child_offsets.end(), m_child_offsets.begin());
    m_children.resize(at(m_child_offsets.back()));
    std::vector<int> next(m_child_offsets.begin(), m_child_offsets.end() - 1);
    for (int s = 0; s < size(); ++s)
      if (parent(s) >= 0) m_children[at(next[at(parent(s))]++)] = s;
    m_depth.assign(at(size()), 0);
    for (int s = size() - 1; s >= 0; --s)
      if (parent(s) >= 0) m_depth[at(s)] = m_depth[at(parent(s))] + 1;
  }

  template <class Place>
  void number_front(int s, Place& place) const
  {
    for (int j = 0; j < width(s); ++j) place[at(first(s) + j)] = j;
    for (int i = 0; i < height(s); ++i) place[at(rows(s)[i])] = width(s) + i;
  }

  void find_relative_rows()
  {
    m_relative.resize(m_rows.size());
    std::vector<int> place(at(size_of_columns()));
    for (int s = 0; s < size(); ++s) {
      number_front(s, place);
      for (const int* c = children_begin(s); c != children_end(s); ++c)
        for (int i = 0; i < height(*c); ++i)
          m_relative[static_cast<std::size_t>(m_row_offsets[at(*c)] + i)] = place[at(rows(*c)[i])];
    }
  }

  void find_entries(const Permuted_graph& graph, const Sparse_pattern& pattern)
  {
    std::vector<int> supernode(at(size_of_columns())), place(supernode.size());
    for (int s = 0; s < size(); ++s)
      std::fill(supernode.begin() + first(s), supernode.begin() + m_first[at(s) + 1], s);
    m_entry_offsets.assign(at(size()) + 1, 0);
    for (const auto& e : graph.neighbours) ++m_entry_offsets[at(supernode[at(e.column)]) + 1];
    for (int j = 0; j < size_of_columns(); ++j) ++m_entry_offsets[at(supernode[at(j)]) + 1];
    std::partial_sum(m_entry_offsets.begin(), m_entry_offsets.end(), m_entry_offsets.begin());
    m_entries.resize(at(m_entry_offsets.back()));
    std::vector<int> next(m_entry_offsets.begin(), m_entry_offsets.end() - 1);
    const auto add = [&](int i, int j, int source) {
      const int s = supernode[at(j)];
      m_entries[at(next[at(s)]++)] = {source, i, j - first(s)};  // the row in the front comes later
    };
    for (int i = 0; i < size_of_columns(); ++i) {
      add(i, i, pattern.offsets[at(m_order[at(i)])]);
      for (const auto* e = graph.begin(i); e != graph.end(i); ++e) add(i, e->column, e->source);
    }
    for (int s = 0; s < size(); ++s) {
      number_front(s, place);
      for (int k = m_entry_offsets[at(s)]; k < m_entry_offsets[at(s) + 1]; ++k)
        m_entries[at(k)].row = place[at(m_entries[at(k)].row)];
    }
  }

  Ordering m_order;
  std::vector<int> m_first;  // size() + 1
  std::vector<int> m_parent, m_depth, m_child_offsets, m_children;
  std::vector<std::int64_t> m_row_offsets;
  std::vector<int> m_rows, m_relative;
  std::vector<int> m_entry_offsets;
  std::vector<Entry> m_entries;
  std::int64_t m_factor_entries = 0;
  double m_operations = 0;
};

}  // namespace Conformal_geometry_processing

#endif
