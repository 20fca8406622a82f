// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/sweep_cut.h>
#include <Conformal_geometry_processing/threads/Task_pool.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// Regions of at most this size are not dissected. Twice as much saves an eighth of the time, but
/// costs up to 5 % of the operations of a factorization.
constexpr int max_dissection_leaf = 300;

namespace internal {

/// A part of the graph, and the positions of its vertices in the order.
struct Dissection_part {
  Graph_region region;
  int end = 0;  ///< the position after its last vertex
};

/// Dissects parts of a graph independently: the ordering does not depend on their sequence.
class Dissection {
 public:
  /// \param rank of each vertex among those of a leaf
  Dissection(const std::vector<int>& rank, Ordering& order) : m_rank(rank), m_order(order) {}

  /// Places the separator last and returns the two parts
  std::array<Dissection_part, 2> cut(const Dissection_part& part);

  /// Orders a part completely
  void finish(Dissection_part&& all);

 private:
  const std::vector<int>& m_rank;
  Ordering& m_order;
  Sweep_cut m_cut;
};

}  // namespace internal

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
/// with `amd_ordering()` for small regions
internal::Ordering sweep_nested_dissection(const Sparse_pattern& pattern,
                                           const Eigen::Matrix3Xd& positions);

}  // namespace Conformal_geometry_processing
