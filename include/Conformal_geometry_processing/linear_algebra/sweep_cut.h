// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SWEEP_CUT_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SWEEP_CUT_H

#include <Conformal_geometry_processing/linear_algebra/Graph_region.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// the axes of inertia of a set of points, one per column, the longest first
inline Eigen::Matrix3f principal_axes(const Eigen::Matrix<float, Eigen::Dynamic, 3>& points)
{
  const Eigen::RowVector3f mean = points.colwise().mean();
  Eigen::Matrix3f covariance;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b <= a; ++b)
      covariance(a, b) =
          ((points.col(a).array() - mean[a]) * (points.col(b).array() - mean[b])).mean();
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f>()
      .computeDirect(covariance)
      .eigenvectors()
      .rowwise()
      .reverse();
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief finds the plane that cuts a region into two parts of similar size through few edges.
///
/// Sweeps a plane along several directions. Vertices are sorted into slabs; the number of edges cut
/// between two slabs is a running sum of +1 where an edge begins and -1 where it ends. Keeps its
/// arrays from one region to the next.
class Sweep_cut {
 public:
  /// a side for each vertex, both sides with at least a quarter of them. O(vertices + edges).
  /// \pre the region has two vertices or more
  const std::vector<char>& operator()(const Graph_region& region)
  {
    m_best = Cut();
    const Eigen::Matrix3f axes = internal::principal_axes(region.positions);
    for (const Eigen::Vector3f& d : directions(region.size())) sweep(region, (axes * d).eval());
    m_side.resize(region.vertices.size());
    if (m_best.cost < no_cut) {
      sort_into_slabs(region, m_best.direction);
      for (std::size_t v = 0; v < m_side.size(); ++v) m_side[v] = m_slab[v] > m_best.slab;
    } else {
      halve(region, axes.col(0));
    }
    return m_side;
  }

 private:
  static constexpr int slabs = 256;
  static constexpr float no_cut = 1e30f;

  struct Cut {
    float cost = no_cut;
    Eigen::Vector3f direction = Eigen::Vector3f::Zero();
    int slab = 0;  ///< the last one on the left
  };

  // In the frame of the axes of inertia. A long thin region is cut across its length; two
  // oblique planes each way find the necks of the others.
  static std::vector<Eigen::Vector3f> directions(int size)
  {
    constexpr float t = 0.7f;
    if (size < 400) return {{1, 0, 0}, {1, t, 0}, {1, -t, 0}};
    return {{1, 0, 0}, {1, t, 0}, {1, -t, 0}, {1, 0, t}, {1, 0, -t}};
  }

  // False where all vertices lie in one plane across the direction.
  bool sort_into_slabs(const Graph_region& region, const Eigen::Vector3f& direction)
  {
    m_key = (region.positions.col(0) * direction[0] + region.positions.col(1) * direction[1] +
             region.positions.col(2) * direction[2])
                .array();
    const float low = m_key.minCoeff(), high = m_key.maxCoeff();
    const float scale = static_cast<float>(slabs) / (high - low);
    if (!(scale < no_cut)) return false;
    m_slab.resize(region.vertices.size());
    for (std::size_t v = 0; v < m_slab.size(); ++v)
      m_slab[v] = static_cast<std::uint8_t>(std::min(
          slabs - 1, static_cast<int>((m_key[static_cast<Eigen::Index>(v)] - low) * scale)));
    return true;
  }

  void sweep(const Graph_region& region, const Eigen::Vector3f& direction)
  {
    if (!sort_into_slabs(region, direction)) return;
    std::array<int, slabs> vertices{}, edges{};
    for (std::uint8_t s : m_slab) ++vertices[s];
    for (const auto& e : region.edges) {
      const std::uint8_t a = m_slab[static_cast<std::size_t>(e[0])];
      const std::uint8_t b = m_slab[static_cast<std::size_t>(e[1])];
      ++edges[std::min(a, b)];
      --edges[std::max(a, b)];
    }
    int left = 0, cut = 0;
    for (int s = 0; s + 1 < slabs; ++s) {
      left += vertices[static_cast<std::size_t>(s)];
      cut += edges[static_cast<std::size_t>(s)];
      const float share = static_cast<float>(left) / static_cast<float>(region.size());
      if (share < 0.25f || share > 0.75f) continue;
      const float cost = static_cast<float>(cut + 1) / (share * (1 - share));
      if (cost < m_best.cost) m_best = {cost, direction, s};
    }
  }

  // Where many vertices coincide no plane will do: half of them, equal ones by number.
  void halve(const Graph_region& region, const Eigen::Vector3f& direction)
  {
    m_key = (region.positions * direction).array();
    std::vector<int> order(m_side.size());
    std::iota(order.begin(), order.end(), 0);
    const auto middle = order.begin() + region.size() / 2;
    std::nth_element(order.begin(), middle, order.end(), [&](int v, int w) {
      return m_key[v] < m_key[w] || (m_key[v] == m_key[w] && v < w);
    });
    std::fill(m_side.begin(), m_side.end(), char(Graph_region::right));
    for (auto v = order.begin(); v != middle; ++v)
      m_side[static_cast<std::size_t>(*v)] = Graph_region::left;
  }

  Cut m_best;
  Eigen::ArrayXf m_key;
  std::vector<std::uint8_t> m_slab;
  std::vector<char> m_side;
};

}  // namespace Conformal_geometry_processing

#endif
