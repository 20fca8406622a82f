// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Supernodal_structure.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

internal::Permuted_graph::Permuted_graph(const Sparse_pattern& pattern,
                                         const std::vector<int>& new_of_old)
{
  fill(pattern.size(), pattern.size_of_entries() - pattern.size(), [&](auto action) {
    for (int j = 0; j < pattern.size(); ++j)
      for (int k = pattern.offsets[at(j)] + 1; k < pattern.offsets[at(j) + 1]; ++k) {
        const int a = new_of_old[at(pattern.indices[at(k)])], b = new_of_old[at(j)];
        action((std::min)(a, b), Entry{(std::max)(a, b), a > b ? k : ~k});
      }
  });
}

internal::Permuted_graph::Permuted_graph(const internal::Permuted_graph& graph,
                                         const std::vector<int>& place)
{
  fill(graph.size(), static_cast<int>(graph.entries.size()), [&](auto action) {
    for (int j = 0; j < graph.size(); ++j)
      for (const Entry* e = graph.begin(j); e != graph.end(j); ++e)
        action(place[at(j)], Entry{place[at(e->row)], e->source});
  });
}

internal::Graph_rows::Graph_rows(const internal::Permuted_graph& graph)
    : offsets(graph.offsets.size(), 0), columns(graph.entries.size())
{
  for (const auto& e : graph.entries) ++offsets[at(e.row) + 1];
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for (int j = 0; j < graph.size(); ++j)
    for (const auto* e = graph.begin(j); e != graph.end(j); ++e)
      columns[at(next[at(e->row)]++)] = j;
}

std::vector<int> elimination_tree(const internal::Graph_rows& graph)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> parent(at(graph.size()), -1), ancestor(parent);
  for (int i = 0; i < graph.size(); ++i)
    for (const int* column = graph.begin(i); column != graph.end(i); ++column)
      for (int j = *column; j != -1 && j < i;) {
        const int up = ancestor[at(j)];
        ancestor[at(j)] = i;  // path compression
        if (up == -1) parent[at(j)] = i;
        j = up;
      }
  return parent;
}

std::vector<int> sorted_by(const std::vector<int>& key)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::vector<int> next(key.size() + 2, 0), sorted(key.size());
  for (int k : key) ++next[at(k) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::size_t i = 0; i < key.size(); ++i) sorted[at(next[at(key[i])]++)] = static_cast<int>(i);
  return sorted;
}

std::vector<int> postorder(const std::vector<int>& parent, const std::vector<int>& weight)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int n = static_cast<int>(parent.size());
  const std::vector<int> by_weight = sorted_by(weight);
  std::vector<int> child(parent.size(), -1), sibling(parent.size(), -1), order, path;
  for (int k = n - 1; k >= 0; --k)  // the lightest child becomes the head of its list
    if (const int j = by_weight[at(k)], p = parent[at(j)]; p >= 0) {
      sibling[at(j)] = child[at(p)];
      child[at(p)] = j;
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

std::vector<int> column_counts(const internal::Permuted_graph& graph,
                               const std::vector<int>& parent)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int n = graph.size();
  std::vector<int> first(at(n)), last_leaf(at(n), -1), set(at(n)), count(at(n), 0);
  std::iota(first.begin(), first.end(), 0);
  std::iota(set.begin(), set.end(), 0);
  std::vector<char> is_leaf(at(n), 1);
  for (int j = 0; j < n; ++j)
    if (parent[at(j)] >= 0) {
      first[at(parent[at(j)])] = (std::min)(first[at(parent[at(j)])], first[at(j)]);
      is_leaf[at(parent[at(j)])] = 0;
    }
  const auto find = [&](int j) {
    while (set[at(j)] != j) j = set[at(j)] = set[at(set[at(j)])];
    return j;
  };
  // Row i of the factor is a subtree with root i, determined by its leaves; counts the columns.
  for (int j = 0; j < n; ++j) {
    count[at(j)] += is_leaf[at(j)];
    if (parent[at(j)] >= 0) --count[at(parent[at(j)])];
    for (const auto* e = graph.begin(j); e != graph.end(j); ++e) {
      int& leaf = last_leaf[at(e->row)];
      if (leaf >= first[at(j)]) continue;  // a descendant of j is a neighbour too: j is not a leaf
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
