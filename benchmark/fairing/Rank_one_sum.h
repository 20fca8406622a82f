// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// lists of vertices, one after another
struct Stencils {
  std::vector<std::size_t> offsets{0};
  std::vector<int> vertices;

  std::size_t size() const { return offsets.size() - 1; }
  void close() { offsets.push_back(vertices.size()); }
};

/// \brief A = D + sum_s w_s c_s c_s^T, with D diagonal, where each vector c_s has a few entries:
/// the matrices of all quadratic energies.
///
/// Where the products go is found once.
class Rank_one_sum {
 public:
  Rank_one_sum(int size, Stencils stencils) : m_stencils(std::move(stencils))
  {
    m_matrix = CGP::Hermitian_sparse_matrix<double>(pattern(size));
    for_each_pair([&](std::size_t, std::size_t p, std::size_t q) {
      const auto [low, high] = std::minmax(m_stencils.vertices[p], m_stencils.vertices[q]);
      m_places.push_back(m_matrix.pattern().find(high, low));
    });
  }

  const CGP::Sparse_pattern& pattern() const { return m_matrix.pattern(); }

  /// \param coefficients of all c_s, in the order of the vertices of the stencils
  const CGP::Hermitian_sparse_matrix<double>& assemble(const Eigen::VectorXd& D,
                                                       const Eigen::VectorXd& w,
                                                       const std::vector<double>& coefficients)
  {
    m_matrix.set_zero();
    for (int v = 0; v < m_matrix.size(); ++v)
      m_matrix.value(m_matrix.pattern().offsets[static_cast<std::size_t>(v)]) = D[v];
    auto place = m_places.begin();
    for_each_pair([&](std::size_t s, std::size_t p, std::size_t q) {
      m_matrix.value(*place++) +=
          w[static_cast<Eigen::Index>(s)] * coefficients[p] * coefficients[q];
    });
    return m_matrix;
  }

 private:
  /// visit(s, p, q) for all pairs of places p >= q of each stencil s
  template <class Visitor>
  void for_each_pair(Visitor visit) const
  {
    for (std::size_t s = 0; s < m_stencils.size(); ++s)
      for (std::size_t p = m_stencils.offsets[s]; p < m_stencils.offsets[s + 1]; ++p)
        for (std::size_t q = m_stencils.offsets[s]; q <= p; ++q) visit(s, p, q);
  }

  std::shared_ptr<const CGP::Sparse_pattern> pattern(int size) const
  {
    std::vector<std::vector<int>> columns(static_cast<std::size_t>(size));
    for_each_pair([&](std::size_t, std::size_t p, std::size_t q) {
      const auto [low, high] = std::minmax(m_stencils.vertices[p], m_stencils.vertices[q]);
      columns[static_cast<std::size_t>(low)].push_back(high);
    });
    return CGP::sparse_pattern(std::move(columns));
  }

  Stencils m_stencils;
  CGP::Hermitian_sparse_matrix<double> m_matrix;
  std::vector<int> m_places;  // of the products of pairs
};

}  // namespace cgp_benchmark
