// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/vertex_separator.h>
#include <Quaternionic_linear_algebra/threads/Task_pool.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Finds a cut of a region into two parts of similar size through few edges.
///
/// Sweeps a plane along several directions. Vertices are sorted into slabs; the number of edges cut
/// between two slabs is a running sum of +1 at the lower end of an edge and -1 at its upper one.
/// The slabs around the best plane form a thick separator, which is to be thinned. Reuses its
/// arrays for the next region.
class Sweep_cut {
 public:
  /// Returns a side for each vertex, at least a quarter of them left, and right. Edges may join
  /// left and right without passing the separator, which is empty if many vertices coincide.
  /// O(vertices + edges).
  /// \pre the region has two vertices or more
  const std::vector<Side>& operator()(const Graph_region& region);

 private:
  static constexpr int slabs = 256;
  static constexpr std::size_t directions = 5;
  static constexpr float no_cut = 1e30f;
  static constexpr float least_share = 0.25f;  ///< of the vertices, left and right

  struct Cut {
    float cost = no_cut;
    std::size_t direction = 0;
    int slab = 0;  ///< the last one on the left
  };

  /// of a vertex for each direction; eight bytes, which a processor compares at once
  using Slabs = std::array<std::uint8_t, 8>;

  struct Sum {
    int vertices, growth;  ///< of a slab; of the edges cut, from one slab to the next
  };

  // The share of the vertices that a thick separator takes from either side: three rows of them,
  // because the minimum cut is rarely straight, and some more, because the best neck may be
  // elsewhere. A third of these saves a third of the time, but costs up to 7 % of the operations of
  // a factorization.
  static float band_share(int size) { return 0.03f + 2.5f / std::sqrt(static_cast<float>(size)); }

  void set_keys(const Graph_region& region, const Eigen::Vector3f& direction);
  void sort_into_slabs(const Graph_region& region, const Eigen::Matrix3f& axes);
  void count_slabs(const Graph_region& region);
  void sweep(std::size_t direction, int size);
  void take_slabs(const Graph_region& region);
  void halve(const Graph_region& region, const Eigen::Vector3f& direction);

  Cut m_best;
  Eigen::ArrayXf m_key;
  std::vector<int> m_degree;
  std::vector<Slabs> m_slabs;
  std::array<std::array<Sum, slabs>, directions> m_sums;
  std::vector<Side> m_sides;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// Regions of at most this size are not dissected. Twice as much saves an eighth of the time, but
/// costs up to 5 % of the operations of a factorization.
constexpr int max_dissection_leaf = 300;

/// \ingroup PkgLinearAlgebra
/// \brief Nested dissection ordering (George 1973) with separators computed from positions.
///
/// Bisects the graph by a slab between parallel planes (`Sweep_cut`), eliminates a minimum set of
/// vertices of the slab that separates the two parts last (`thin_separator()`), and recurses. Small
/// regions keep the order that minimum degree gives them in the whole graph, where it eliminates
/// what is local first. On meshes the fill is about that of METIS, in a third of its time:
/// positions replace the hierarchy of coarser graphs, and a minimum cut needs no refinement.
/// Positions affect the cuts only: any positions give a valid ordering, good ones place neighbours
/// close to each other. Deterministic, for any number of threads.
/// O((vertices + edges) log(vertices)) on meshes.
/// \param positions 3 x n, finite, in any unit
/// \param by_degree the ordering of small regions
/// \pre `by_degree` is a permutation
internal::Ordering sweep_nested_dissection(const Sparse_pattern& pattern,
                                           const Eigen::Matrix3Xd& positions,
                                           const internal::Ordering& by_degree);

/// \ingroup PkgLinearAlgebra
/// \brief The same with an ordering of small regions that is yet to be found, which other threads
/// need not wait for.
/// \param find_by_degree returns the ordering, or null where it is good enough for the whole: the
/// result is then empty. On one thread it is called first, on several at the same time as the cuts
internal::Ordering sweep_nested_dissection(
    const Sparse_pattern& pattern, const Eigen::Matrix3Xd& positions,
    const std::function<const internal::Ordering*()>& find_by_degree);

/// \ingroup PkgLinearAlgebra
/// with `amd_ordering()` for small regions
internal::Ordering sweep_nested_dissection(const Sparse_pattern& pattern,
                                           const Eigen::Matrix3Xd& positions);

}  // namespace Conformal_geometry_processing
