// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_MINIMUM_DEGREE_WITH_HALO_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_MINIMUM_DEGREE_WITH_HALO_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/direct/minimum_degree_with_halo.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// Number of bits that are set
CGP_INLINE int population_count(std::uint64_t x)
{
  x -= (x >> 1) & 0x5555555555555555u;
  x = (x & 0x3333333333333333u) + ((x >> 2) & 0x3333333333333333u);
  x = (x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fu;
  return static_cast<int>((x * 0x0101010101010101u) >> 56);
}

}  // namespace internal

CGP_INLINE const std::vector<int>& internal::Minimum_degree_with_halo::operator()(
    const internal::Graph_region& region)
{
  build(region);
  m_remaining.resize(region.vertices.size());
  for (std::size_t v = 0; v < m_remaining.size(); ++v) m_remaining[v] = static_cast<int>(v);
  m_order.clear();
  while (!m_remaining.empty()) {
    const auto least = std::min_element(m_remaining.begin(), m_remaining.end(), [&](int a, int b) {
      return m_degree[at(a)] < m_degree[at(b)];
    });
    const int v = *least;
    m_remaining.erase(least);
    m_order.push_back(region.vertices[at(v)]);
    eliminate(v);
  }
  return m_order;
}

// Columns are the vertices of the region, followed by those of the halo.
CGP_INLINE void internal::Minimum_degree_with_halo::build(const internal::Graph_region& region)
{
  m_halo.clear();
  for (const auto& e : region.halo) m_halo.push_back(e[1]);
  std::sort(m_halo.begin(), m_halo.end());
  m_halo.erase(std::unique(m_halo.begin(), m_halo.end()), m_halo.end());
  m_inner_words = (region.vertices.size() + 63) / 64;
  m_words = (region.vertices.size() + m_halo.size() + 63) / 64;
  m_bits.assign(region.vertices.size() * m_words, 0);
  const auto connect = [&](int i, int j) { row(i)[j >> 6] |= bit(j); };
  for (const auto& e : region.edges) {
    connect(e[0], e[1]);
    connect(e[1], e[0]);
  }
  for (const auto& e : region.halo) {
    const auto place = std::lower_bound(m_halo.begin(), m_halo.end(), e[1]) - m_halo.begin();
    connect(e[0], region.size() + static_cast<int>(place));
  }
  m_degree.resize(region.vertices.size());
  for (int v = 0; v < region.size(); ++v) update_degree(v);
}

CGP_INLINE void internal::Minimum_degree_with_halo::update_degree(int v)
{
  int degree = 0;
  for (std::size_t k = 0; k < m_words; ++k) degree += internal::population_count(row(v)[k]);
  m_degree[at(v)] = degree;
}

// Makes the neighbours of v adjacent to each other.
CGP_INLINE void internal::Minimum_degree_with_halo::eliminate(int v)
{
  const int size = static_cast<int>(m_degree.size());
  const std::uint64_t* const of_v = row(v);
  for (std::size_t w = 0; w < m_inner_words; ++w)
    for (std::uint64_t rest = of_v[w]; rest != 0; rest &= rest - 1) {
      const int u = static_cast<int>(64 * w) + internal::population_count((rest & (~rest + 1)) - 1);
      if (u >= size) return;  // the rest is halo
      std::uint64_t* const of_u = row(u);
      for (std::size_t k = 0; k < m_words; ++k) of_u[k] |= of_v[k];
      of_u[u >> 6] &= ~bit(u);
      of_u[v >> 6] &= ~bit(v);
      update_degree(u);
    }
}

}  // namespace Conformal_geometry_processing

#endif
