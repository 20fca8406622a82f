// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Elimination.h>

#include <algorithm>
#include <utility>

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
                               const std::vector<int>& parent, const std::vector<int>& post)
{
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const int n = graph.size();
  std::vector<int> first(at(n), n), last_leaf(at(n), -1), set(at(n)), count(at(n), 0);
  std::iota(set.begin(), set.end(), 0);
  const auto find = [&](int j) {
    while (set[at(j)] != j) j = set[at(j)] = set[at(set[at(j)])];
    return j;
  };
  // Row i of the factor is a subtree with root i, determined by its leaves; counts the columns.
  // Leaves and first descendants are places in the postorder.
  for (int k = 0; k < n; ++k) {
    const int j = post[at(k)], up = parent[at(j)];
    if (first[at(j)] == n) {  // no child has been here
      first[at(j)] = k;
      ++count[at(j)];
    }
    if (up >= 0) {
      first[at(up)] = (std::min)(first[at(up)], first[at(j)]);
      --count[at(up)];
    }
    for (const auto* e = graph.begin(j); e != graph.end(j); ++e) {
      int& leaf = last_leaf[at(e->row)];
      if (leaf >= first[at(j)]) continue;  // a descendant of j is a neighbour too: j is not a leaf
      ++count[at(j)];
      if (leaf >= 0) --count[at(find(post[at(leaf)]))];  // twice from the common ancestor upward
      leaf = k;
    }
    if (up >= 0) set[at(j)] = up;
  }
  for (const int j : post)
    if (parent[at(j)] >= 0) count[at(parent[at(j)])] += count[at(j)];
  return count;
}

namespace internal {

Elimination::Elimination(const Sparse_pattern& pattern, const Ordering& order, int kept)
    : m_order(order),
      m_graph(pattern, inverse_permutation(order)),
      m_parent(elimination_tree(Graph_rows(m_graph)))
{
  chain_kept(kept);
  m_count = column_counts(m_graph, m_parent, postorder(m_parent, std::vector<int>(order.size())));
  std::fill(m_count.end() - kept, m_count.end(), 0);  // valid for eliminated columns only
  renumber(postorder(m_parent, m_count));
  cut_kept(kept);
}

// Chains the kept columns into a path above all others, as if they were a clique, so that any
// postorder keeps them last and in their order. The counts of other columns are independent of it.
void Elimination::chain_kept(int kept)
{
  const int n = size_of_columns(), first_kept = n - kept;
  for (int& p : m_parent)
    if (p >= first_kept) p = first_kept;
  for (int j = first_kept; j < n; ++j) m_parent[at(j)] = j + 1 < n ? j + 1 : -1;
}

void Elimination::renumber(const std::vector<int>& post)
{
  const std::vector<int> place = inverse_permutation(post);
  std::vector<int> order, parent, count;
  for (std::vector<int>* v : {&order, &parent, &count}) v->reserve(post.size());
  for (const int j : post) {
    order.push_back(m_order[at(j)]);
    parent.push_back(m_parent[at(j)] < 0 ? -1 : place[at(m_parent[at(j)])]);
    count.push_back(m_count[at(j)]);
  }
  m_order = std::move(order);
  m_parent = std::move(parent);
  m_count = std::move(count);
  m_graph = Permuted_graph(m_graph, place);
}

// Removes the kept columns, so that only the other columns form supernodes.
void Elimination::cut_kept(int kept)
{
  const int eliminated = size_of_columns() - kept;
  m_parent.resize(at(eliminated));
  m_count.resize(at(eliminated));
  for (int& p : m_parent)
    if (p >= eliminated) p = -1;
}

std::int64_t Elimination::factor_entries() const
{
  return std::accumulate(m_count.begin(), m_count.end(), std::int64_t{0});
}

double Elimination::operations() const
{
  double sum = 0;
  for (const int c : m_count) sum += static_cast<double>(c) * c;
  return sum;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing
