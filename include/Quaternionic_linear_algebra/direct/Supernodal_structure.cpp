// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Supernodal_structure.h>

#include <algorithm>
#include <numeric>

namespace Conformal_geometry_processing {
namespace internal {

std::vector<int> fundamental_supernodes(const std::vector<int>& parent,
                                        const std::vector<int>& count)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int n = static_cast<int>(parent.size());
  std::vector<int> children(at(n), 0), first;
  for (int p : parent)
    if (p >= 0) ++children[at(p)];
  for (int j = 0; j < n; ++j)
    if (j == 0 || parent[at(j - 1)] != j || count[at(j - 1)] != count[at(j)] + 1 ||
        children[at(j)] > 1)
      first.push_back(j);
  first.push_back(n);
  return first;
}

/// Returns whether a supernode of this width may have this share of zeros among its entries: the
/// narrower it is, the more it gains from the dense kernels.
bool is_worth_its_zeros(int width, double zeros)
{
  return width <= 4 || (width <= 16 && zeros < 0.8) || (width <= 48 && zeros < 0.1) || zeros < 0.05;
}

}  // namespace internal

std::vector<int> relaxed_supernodes(const std::vector<int>& parent, const std::vector<int>& count)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const std::vector<int> first = internal::fundamental_supernodes(parent, count);
  const int size = static_cast<int>(first.size()) - 1;
  // Of the group that begins with supernode s: number of columns, rows of the first column, zeros.
  std::vector<int> width(at(size)), height(at(size));
  std::vector<double> zeros(at(size), 0);
  std::vector<char> is_begin(at(size) + 1, 1);
  for (int s = size - 1; s >= 0; --s) {
    width[at(s)] = first[at(s + 1)] - first[at(s)];
    height[at(s)] = count[at(first[at(s)])];
    const int up = parent[at(first[at(s + 1)] - 1)];
    if (s + 1 == size || up < first[at(s + 1)] || up >= first[at(s + 2)]) continue;
    const int w = width[at(s)] + width[at(s + 1)], h = width[at(s)] + height[at(s + 1)];
    const double added = static_cast<double>(width[at(s)]) * (h - height[at(s)]);
    const double all = zeros[at(s + 1)] + added;
    const double entries = w * (w + 1.) / 2 + static_cast<double>(w) * (h - w);
    if (added > 0 && !internal::is_worth_its_zeros(w, all / entries)) continue;
    width[at(s)] = w;
    height[at(s)] = h;
    zeros[at(s)] = all;
    is_begin[at(s + 1)] = 0;
  }
  std::vector<int> result;
  for (int s = 0; s < size; ++s) {
    if (!is_begin[at(s)]) continue;
    const int pieces = (width[at(s)] + max_supernode_width - 1) / max_supernode_width;
    for (int p = 0; p < pieces; ++p)
      result.push_back(first[at(s)] +
                       static_cast<int>(static_cast<long long>(width[at(s)]) * p / pieces));
  }
  result.push_back(first.back());
  return result;
}

internal::Supernodal_structure::Supernodal_structure(const Sparse_pattern& pattern,
                                                     const Elimination& elimination)
    : m_order(elimination.order()),
      m_kept(elimination.size_of_kept()),
      m_first(relaxed_supernodes(elimination.parent(), elimination.count())),
      m_factor_entries(elimination.factor_entries()),
      m_operations(elimination.operations())
{
  find_tree(elimination.parent(), elimination.count());
  find_rows(Graph_rows(elimination.graph()));
  find_places(elimination.graph(), pattern);
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
