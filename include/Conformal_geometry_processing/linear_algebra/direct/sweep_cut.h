// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Graph_region.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
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
  static constexpr float no_cut = 1e30f;
  static constexpr float least_share = 0.25f;  ///< of the vertices, left and right

  struct Cut {
    float cost = no_cut;
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();
    int slab = 0;  ///< the last one on the left
  };

  // The share of the vertices that a thick separator takes from either side: three rows of them,
  // because the minimum cut is rarely straight, and some more, because the best neck may be
  // elsewhere. A third of these saves a third of the time, but costs up to 7 % of the operations of
  // a factorization.
  static float band_share(int size) { return 0.03f + 2.5f / std::sqrt(static_cast<float>(size)); }

  static std::array<Eigen::Vector3f, 5> directions();
  void set_keys(const Graph_region& region, const Eigen::Vector3f& direction);
  bool sort_into_slabs(const Graph_region& region, const Eigen::Vector3f& direction);
  void count_lower_ends(const Graph_region& region);
  void sweep(const Graph_region& region, const Eigen::Vector3f& direction);
  void take_slabs(const Graph_region& region);
  void halve(const Graph_region& region, const Eigen::Vector3f& direction);

  Cut m_best;
  Eigen::ArrayXf m_key;
  std::vector<int> m_degree;
  std::vector<std::uint8_t> m_slab;
  std::array<std::array<int, slabs>, 2> m_lower_ends;
  std::vector<Side> m_sides;
};

}  // namespace Conformal_geometry_processing::internal
