// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>

#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// A part of the graph, and the positions of its vertices in the order.
struct Dissection_part {
  Graph_region region;
  int end = 0;  ///< the position after its last vertex
};

/// Dissects parts of a graph independently: the ordering does not depend on their sequence.
class Dissection {
 public:
  /// \param[out] order gets the separators
  /// \param[in,out] leaf of each vertex the place in the order where its leaf begins; that of
  /// separators is left as it is
  Dissection(Ordering& order, std::vector<int>& leaf) : m_order(order), m_leaf(leaf) {}

  /// Places the separator last and returns the two parts
  std::array<Dissection_part, 2> cut(const Dissection_part& part)
  {
    const Graph_region& region = part.region;
    std::vector<Side> sides = m_cut(region);
    thin_separator(region, sides);
    int end = part.end;
    for (int v = region.size() - 1; v >= 0; --v)
      if (sides[static_cast<std::size_t>(v)] == Side::separator)
        m_order[static_cast<std::size_t>(--end)] = region.vertices[static_cast<std::size_t>(v)];
    std::array<Graph_region, 2> halves = split(region, sides);
    const int middle = end - halves[1].size();
    return {{{std::move(halves[0]), middle}, {std::move(halves[1]), end}}};
  }

  /// Dissects a part down to leaves
  void finish(Dissection_part&& all)
  {
    std::vector<Dissection_part> stack;
    stack.push_back(std::move(all));
    while (!stack.empty()) {
      Dissection_part part = std::move(stack.back());
      stack.pop_back();
      if (part.region.size() <= max_dissection_leaf) {
        const int begin = part.end - part.region.size();
        for (const int v : part.region.vertices) m_leaf[static_cast<std::size_t>(v)] = begin;
      } else {
        for (Dissection_part& half : cut(part)) stack.push_back(std::move(half));
      }
    }
  }

 private:
  Ordering& m_order;
  std::vector<int>& m_leaf;
  Sweep_cut m_cut;
};

/// Returns the principal axes of inertia of a set of points, one per column, the longest first
Eigen::Matrix3f principal_axes(const Eigen::Matrix<float, Eigen::Dynamic, 3>& points)
{
  const Eigen::RowVector3f mean = points.colwise().mean();
  Block<float> covariance(3, 3);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b <= a; ++b)
      covariance(a, b) = covariance(b, a) =
          ((points.col(a).array() - mean[a]) * (points.col(b).array() - mean[b])).mean();
  return hermitian_jacobi(covariance).vectors.rowwise().reverse();
}

}  // namespace internal

const std::vector<internal::Side>& internal::Sweep_cut::operator()(
    const internal::Graph_region& region)
{
  m_best = Cut();
  m_degree.assign(region.vertices.size(), 0);
  for (const auto& e : region.edges)
    for (int v : e) ++m_degree[static_cast<std::size_t>(v)];
  const Eigen::Matrix3f axes = internal::principal_axes(region.positions);
  sort_into_slabs(region, axes);
  count_slabs(region);
  for (std::size_t d = 0; d < directions; ++d) sweep(d, region.size());
  m_sides.resize(region.vertices.size());
  if (m_best.cost < no_cut)
    take_slabs(region);
  else
    halve(region, axes.col(0));
  return m_sides;
}

// Computes the coordinates of the vertices along the direction.
void internal::Sweep_cut::set_keys(const internal::Graph_region& region,
                                   const Eigen::Vector3f& direction)
{
  m_key = (region.positions.col(0) * direction[0] + region.positions.col(1) * direction[1] +
           region.positions.col(2) * direction[2])
              .array();
}

// In the frame of the axes of inertia. A long thin region is cut across its length; for other
// regions, oblique planes find necks. Vertices in one plane orthogonal to a direction are all in
// its first slab.
void internal::Sweep_cut::sort_into_slabs(const internal::Graph_region& region,
                                          const Eigen::Matrix3f& axes)
{
  constexpr float t = 0.7f;
  const std::array<Eigen::Vector3f, directions> oblique = {
      {{1, 0, 0}, {1, t, 0}, {1, -t, 0}, {1, 0, t}, {1, 0, -t}}};
  m_slabs.assign(region.vertices.size(), Slabs{});
  for (std::size_t d = 0; d < directions; ++d) {
    set_keys(region, axes * oblique[d]);
    const float low = m_key.minCoeff(), high = m_key.maxCoeff();
    const float scale = static_cast<float>(slabs) / (high - low);
    if (!(scale < no_cut)) continue;
    for (std::size_t v = 0; v < m_slabs.size(); ++v)
      m_slabs[v][d] = static_cast<std::uint8_t>((std::min)(
          slabs - 1, static_cast<int>((m_key[static_cast<Eigen::Index>(v)] - low) * scale)));
  }
}

// An edge counts from its lower end to its upper one, and both ends are among the degrees. All
// directions in one pass: edges are read once, and a processor that waits for a number that it has
// just written goes on with the next.
void internal::Sweep_cut::count_slabs(const internal::Graph_region& region)
{
  m_sums = {};
  for (std::size_t v = 0; v < m_slabs.size(); ++v)
    for (std::size_t d = 0; d < directions; ++d) {
      Sum& sum = m_sums[d][m_slabs[v][d]];
      ++sum.vertices;
      sum.growth -= m_degree[v];
    }
  for (const auto& e : region.edges) {
    const Slabs a = m_slabs[static_cast<std::size_t>(e[0])],
                b = m_slabs[static_cast<std::size_t>(e[1])];
    Slabs lower;
    for (std::size_t d = 0; d < lower.size(); ++d) lower[d] = (std::min)(a[d], b[d]);
    for (std::size_t d = 0; d < directions; ++d) m_sums[d][lower[d]].growth += 2;
  }
}

void internal::Sweep_cut::sweep(std::size_t direction, int size)
{
  int lefts = 0, cut = 0;
  for (int s = 0; s + 1 < slabs; ++s) {
    const Sum& sum = m_sums[direction][static_cast<std::size_t>(s)];
    lefts += sum.vertices;
    cut += sum.growth;
    const float share = static_cast<float>(lefts) / static_cast<float>(size);
    if (share < least_share || share > 1 - least_share) continue;
    const float cost = static_cast<float>(cut + 1) / (share * (1 - share));
    if (cost < m_best.cost) m_best = {cost, direction, s};
  }
}

// Widens the best cut slab by slab.
void internal::Sweep_cut::take_slabs(const internal::Graph_region& region)
{
  const std::array<Sum, slabs>& sums = m_sums[m_best.direction];
  const auto size = static_cast<float>(region.size());
  const auto end = [&](int slab, int step, int rest) {
    int taken = 0;
    for (; slab >= 0 && slab < slabs; slab += step) {
      taken += sums[static_cast<std::size_t>(slab)].vertices;
      rest -= sums[static_cast<std::size_t>(slab)].vertices;
      if (static_cast<float>(taken) > band_share(region.size()) * size ||
          static_cast<float>(rest) < least_share * size)
        break;
    }
    return slab;
  };
  const int lefts = std::accumulate(sums.begin(), sums.begin() + m_best.slab + 1, 0,
                                    [](int sum, const Sum& slab) { return sum + slab.vertices; });
  const int last_left = end(m_best.slab, -1, lefts);
  const int first_right = end(m_best.slab + 1, 1, region.size() - lefts);
  for (std::size_t v = 0; v < m_sides.size(); ++v) {
    const int slab = m_slabs[v][m_best.direction];
    m_sides[v] = slab <= last_left     ? internal::Side::left
                 : slab >= first_right ? internal::Side::right
                                       : internal::Side::separator;
  }
}

// If many vertices coincide, no plane separates them: bisects them, ties by index.
void internal::Sweep_cut::halve(const internal::Graph_region& region,
                                const Eigen::Vector3f& direction)
{
  set_keys(region, direction);
  std::vector<int> order(m_sides.size());
  std::iota(order.begin(), order.end(), 0);
  const auto middle = order.begin() + region.size() / 2;
  std::nth_element(order.begin(), middle, order.end(), [&](int v, int w) {
    return m_key[v] < m_key[w] || (m_key[v] == m_key[w] && v < w);
  });
  std::fill(m_sides.begin(), m_sides.end(), internal::Side::right);
  for (auto v = order.begin(); v != middle; ++v)
    m_sides[static_cast<std::size_t>(*v)] = internal::Side::left;
}

namespace internal {

/// Places the vertices of leaves as they follow each other by degree
void order_leaves(const Ordering& by_degree, const std::vector<int>& leaf, Ordering& order)
{
  std::vector<int> taken(order.size(), 0);  // of the leaf that begins at a place
  for (const int v : by_degree)
    if (const int begin = leaf[static_cast<std::size_t>(v)]; begin >= 0)
      order[static_cast<std::size_t>(begin + taken[static_cast<std::size_t>(begin)]++)] = v;
}

/// The first cuts form a binary tree of tasks: part t is cut into the parts 2t and 2t + 1. Task 0
/// is what another thread does at the same time; it returns whether the cuts are still wanted.
void dissect_in_parallel(Dissection_part&& all, int threads, Ordering& order,
                         std::vector<int>& leaf, const std::function<bool()>& beside)
{
  constexpr int parts_at_most = 128, smallest = 1000;
  std::vector<Dissection_part> parts(parts_at_most);
  parts[1] = std::move(all);
  std::atomic<bool> is_wanted = true;
  Task_pool pool(threads);
  pool.run({0, 1}, [&](int t) {
    if (t == 0) is_wanted = beside();
    if (t == 0 || !is_wanted) return;
    Dissection dissection(order, leaf);
    Dissection_part part = std::move(parts[static_cast<std::size_t>(t)]);
    if (2 * t >= parts_at_most || part.region.size() < smallest)
      return dissection.finish(std::move(part));
    std::array<Dissection_part, 2> halves = dissection.cut(part);
    part.region = Graph_region();
    for (int i = 1; i >= 0; --i) {
      parts[static_cast<std::size_t>(2 * t + i)] = std::move(halves[static_cast<std::size_t>(i)]);
      pool.push(2 * t + i);
    }
  });
}

}  // namespace internal

internal::Ordering sweep_nested_dissection(const Sparse_pattern& pattern,
                                           const Eigen::Matrix3Xd& positions)
{
  return sweep_nested_dissection(pattern, positions, amd_ordering(pattern));
}

internal::Ordering sweep_nested_dissection(const Sparse_pattern& pattern,
                                           const Eigen::Matrix3Xd& positions,
                                           const internal::Ordering& by_degree)
{
  return sweep_nested_dissection(pattern, positions, [&] { return &by_degree; });
}

internal::Ordering sweep_nested_dissection(
    const Sparse_pattern& pattern, const Eigen::Matrix3Xd& positions,
    const std::function<const internal::Ordering*()>& find_by_degree)
{
  constexpr int worth_threads = 4000;  // vertices: some milliseconds
  const int threads = pattern.size() < worth_threads ? 1 : number_of_threads();
  const internal::Ordering* by_degree = threads > 1 ? nullptr : find_by_degree();
  if (threads == 1 && by_degree == nullptr) return {};
  internal::Ordering order(static_cast<std::size_t>(pattern.size()));
  std::vector<int> leaf(order.size(), -1);
  internal::Dissection_part all{graph_region(pattern, positions), pattern.size()};
  if (threads > 1)
    internal::dissect_in_parallel(std::move(all), threads, order, leaf,
                                  [&] { return (by_degree = find_by_degree()) != nullptr; });
  else
    internal::Dissection(order, leaf).finish(std::move(all));
  if (by_degree == nullptr) return {};
  internal::order_leaves(*by_degree, leaf, order);
  return order;
}

}  // namespace Conformal_geometry_processing
