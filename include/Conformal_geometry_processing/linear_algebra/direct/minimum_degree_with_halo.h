// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_MINIMUM_DEGREE_WITH_HALO_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_MINIMUM_DEGREE_WITH_HALO_H

#include <Conformal_geometry_processing/linear_algebra/direct/Graph_region.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Orders the vertices of a small region by minimum degree with halo: surrounding separator
/// vertices, which are eliminated later, count as neighbours but are not ordered.
///
/// The elimination graph is a bit matrix, so that eliminating a vertex combines its row with those
/// of its neighbours by OR, and degrees are exact. At worst O(size^2) words of 64 bits in time per
/// 64 vertices, size^2 / 8 bytes. Reuses its arrays for the next region.
class Minimum_degree_with_halo {
 public:
  /// Returns the vertices of the region in elimination order, as indices of the whole graph
  const std::vector<int>& operator()(const Graph_region& region);

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::uint64_t* row(int v) { return m_bits.data() + at(v) * m_words; }
  static std::uint64_t bit(int j) { return std::uint64_t(1) << (j & 63); }

  void build(const Graph_region& region);
  void update_degree(int v);
  void eliminate(int v);

  std::size_t m_words = 0, m_inner_words = 0;
  std::vector<std::uint64_t> m_bits;
  std::vector<int> m_halo, m_degree, m_remaining, m_order;
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/minimum_degree_with_halo_impl.h>
#endif

#endif
