// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/elimination_tree.h>

#include <algorithm>
#include <cstddef>
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

}  // namespace Conformal_geometry_processing
