// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SWEEP_NESTED_DISSECTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SWEEP_NESTED_DISSECTION_H

#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Task_pool.h>
#include <Conformal_geometry_processing/linear_algebra/direct/minimum_degree_with_halo.h>
#include <Conformal_geometry_processing/linear_algebra/direct/sweep_cut.h>

#include <Eigen/Core>

#include <array>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// regions of so many vertices are ordered by minimum degree
constexpr int max_dissection_leaf = 120;

namespace internal {

/// A part of the graph, and the places of its vertices in the order.
struct Dissection_part {
  Graph_region region;
  int end = 0;  ///< the place after its last vertex
};

/// Takes parts of a graph apart, each on its own: any order of the parts gives the same ordering.
class Dissection {
 public:
  explicit Dissection(Ordering& order) : m_order(order) {}

  /// separator last, then the two parts
  std::array<Dissection_part, 2> cut(const Dissection_part& part);

  /// all of it
  void finish(Dissection_part&& all);

 private:
  Ordering& m_order;
  Sweep_cut m_cut;
  Minimum_degree_with_halo m_minimum_degree;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief the ordering of nested dissection (George 1973) with separators found from positions.
///
/// Cuts the graph in two by a slab between parallel planes (`Sweep_cut`), eliminates last the
/// fewest vertices of the slab that keep the two parts asunder (`thin_separator()`), and goes on
/// with the parts. On meshes the fill is that of METIS or less, in half its time or less: positions
/// save the hierarchy of coarser graphs, and a smallest cut needs no refinement. Positions steer
/// the cuts only: any give a valid ordering, good ones put neighbours close to each other. The same
/// input gives the same ordering, for any number of threads.
/// O((vertices + edges) log(vertices)) on meshes.
/// \param positions 3 x n, finite, in any unit
Ordering sweep_nested_dissection(const Sparse_pattern& pattern, const Eigen::Matrix3Xd& positions);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/sweep_nested_dissection_impl.h>
#endif

#endif
