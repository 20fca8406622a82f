// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_structure.h>

#include <Conformal_geometry_processing/linear_algebra/direct/elimination_tree.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

internal::Supernodal_structure::Supernodal_structure(const Sparse_pattern& pattern,
                                                     const internal::Ordering& order, int kept)
    : m_order(order), m_kept(kept)
{
  internal::Permuted_graph graph(pattern, inverse_permutation(order));
  std::vector<int> parent = elimination_tree(internal::Graph_rows(graph));
  chain_kept(parent);
  renumber(graph, parent, std::vector<int>(order.size(), 0));
  std::vector<int> count = column_counts(graph, parent);
  std::fill(count.end() - kept, count.end(), 0);  // valid for eliminated columns only
  count = gathered(count, renumber(graph, parent, count));
  cut_kept(parent, count);
  count_operations(count);
  m_first = relaxed_supernodes(parent, count);
  find_tree(parent, count);
  find_rows(internal::Graph_rows(graph));
  find_places(graph, pattern);
}

int internal::Supernodal_structure::height(int s) const
{
  return static_cast<int>(m_row_offsets[at(s) + 1] - m_row_offsets[at(s)]);
}

std::int64_t internal::Supernodal_structure::stored_entries() const
{
  std::int64_t sum = 0;
  for (int s = 0; s < size(); ++s)
    sum += static_cast<std::int64_t>(width(s)) * (width(s) + 1) / 2 +
           static_cast<std::int64_t>(width(s)) * height(s);
  return sum;
}

std::vector<int> internal::Supernodal_structure::gathered(const std::vector<int>& values,
                                                          const std::vector<int>& places)
{
  std::vector<int> result(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) result[k] = values[at(places[k])];
  return result;
}

// Refines the ordering to a postorder of its tree and returns that tree.
std::vector<int> internal::Supernodal_structure::renumber(internal::Permuted_graph& graph,
                                                          std::vector<int>& parent,
                                                          const std::vector<int>& weight)
{
  const std::vector<int> post = postorder(parent, weight), place = inverse_permutation(post);
  m_order = gathered(m_order, post);
  parent = gathered(parent, post);
  for (int& p : parent)
    if (p >= 0) p = place[at(p)];
  graph = internal::Permuted_graph(graph, place);
  return post;
}

// Chains the kept columns into a path above all others, as if they were a clique, so that any
// postorder keeps them last and in their order. The counts of other columns are independent of it.
void internal::Supernodal_structure::chain_kept(std::vector<int>& parent) const
{
  const int n = size_of_columns(), first_kept = n - m_kept;
  for (int& p : parent)
    if (p >= first_kept) p = first_kept;
  for (int j = first_kept; j < n; ++j) parent[at(j)] = j + 1 < n ? j + 1 : -1;
}

// Removes the kept columns, so that only the other columns form supernodes.
void internal::Supernodal_structure::cut_kept(std::vector<int>& parent,
                                              std::vector<int>& count) const
{
  const int eliminated = size_of_columns() - m_kept;
  parent.resize(at(eliminated));
  count.resize(at(eliminated));
  for (int& p : parent)
    if (p >= eliminated) p = -1;
}

void internal::Supernodal_structure::count_operations(const std::vector<int>& count)
{
  for (int c : count) {
    m_factor_entries += c;
    m_operations += static_cast<double>(c) * c;
  }
}

// The rows below a supernode, and its parent, are those of its last column.
void internal::Supernodal_structure::find_tree(const std::vector<int>& parent,
                                               const std::vector<int>& count)
{
  m_supernode.assign(m_order.size(), -1);
  m_row_offsets.assign(1, 0);
  for (int s = 0; s < size(); ++s) {
    std::fill_n(m_supernode.begin() + first(s), width(s), s);
    m_row_offsets.push_back(m_row_offsets.back() + count[at(first(s) + width(s) - 1)] - 1);
  }
  for (int s = 0; s < size(); ++s) {
    const int up = parent[at(first(s) + width(s) - 1)];
    m_parent.push_back(up < 0 ? -1 : m_supernode[at(up)]);
  }
  find_children();
}

// Row i belongs to all supernodes on the tree paths from its entries to its own supernode.
void internal::Supernodal_structure::find_rows(const internal::Graph_rows& graph)
{
  m_rows.resize(static_cast<std::size_t>(m_row_offsets.back()));
  std::vector<std::int64_t> next(m_row_offsets.begin(), m_row_offsets.end() - 1);
  std::vector<int> mark(at(size()), -1);
  for (int i = 0; i < size_of_columns(); ++i) {
    if (m_supernode[at(i)] >= 0) mark[at(m_supernode[at(i)])] = i;
    for (const int* j = graph.begin(i); j != graph.end(i); ++j)
      for (int s = m_supernode[at(*j)]; s >= 0 && mark[at(s)] != i; s = parent(s)) {
        mark[at(s)] = i;
        m_rows[static_cast<std::size_t>(next[at(s)]++)] = i;
      }
  }
}

void internal::Supernodal_structure::find_children()
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

// Computes the positions of the children's rows, and of the matrix entries, in the front.
void internal::Supernodal_structure::find_places(const internal::Permuted_graph& graph,
                                                 const Sparse_pattern& pattern)
{
  m_relative.resize(m_rows.size());
  m_entries.reserve(graph.entries.size() + m_order.size());
  m_entry_offsets.assign(1, 0);
  std::vector<int> place(m_order.size());
  for (int s = 0; s < size(); ++s) {
    for (int j = 0; j < width(s); ++j) place[at(first(s) + j)] = j;
    for (int i = 0; i < height(s); ++i) place[at(rows(s)[i])] = width(s) + i;
    for (const int* c = children_begin(s); c != children_end(s); ++c)
      for (std::int64_t k = m_row_offsets[at(*c)]; k < m_row_offsets[at(*c) + 1]; ++k)
        m_relative[static_cast<std::size_t>(k)] = place[at(m_rows[static_cast<std::size_t>(k)])];
    for (int j = 0; j < width(s); ++j) {
      add_entry(pattern.offsets[at(m_order[at(first(s) + j)])], j, j);
      for (const auto* e = graph.begin(first(s) + j); e != graph.end(first(s) + j); ++e)
        add_entry(e->source, place[at(e->row)], j);
    }
    m_entry_offsets.push_back(static_cast<int>(m_entries.size()));
  }
}

void internal::Supernodal_structure::add_entry(int source, int row, int column)
{
  static_assert(max_supernode_width <= 64);
  m_entries.push_back(
      {source, static_cast<unsigned>(row) & 0x3ffffff, static_cast<unsigned>(column) & 63});
}

}  // namespace Conformal_geometry_processing
