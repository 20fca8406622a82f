// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief An undirected graph with positive weights: every edge is in the lists of both its ends.
struct Connection_graph {
  std::vector<int> offsets;    ///< size() + 1 positions in `neighbors`
  std::vector<int> neighbors;  ///< ascending for each vertex
  std::vector<float> weights;  ///< parallel to `neighbors`

  int size() const { return static_cast<int>(offsets.size()) - 1; }
  int begin(int i) const { return offsets[static_cast<std::size_t>(i)]; }
  int end(int i) const { return offsets[static_cast<std::size_t>(i) + 1]; }
  int neighbor(int k) const { return neighbors[static_cast<std::size_t>(k)]; }
  float weight(int k) const { return weights[static_cast<std::size_t>(k)]; }
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Finds the strongly connected pairs of rows: i and j are connected, with weight
/// w = -Re A_ij, if w > threshold sqrt(A_ii A_jj).
///
/// If the real part of A is approximately a Laplacian, errors that smoothing cannot reduce vary
/// slowly along these connections. Positive entries (opposite obtuse angles) are ignored.
/// \pre the diagonal of A is positive
template <class Scalar>
internal::Connection_graph strong_connections(const Hermitian_sparse_matrix<Scalar>& A,
                                              double threshold)
{
  const auto for_each_connection = [&](auto visit) {
    A.for_each_entry([&](int i, int j, const Scalar& a) {
      if (i == j) return;
      const double w = -static_cast<double>(internal::Scalar_traits<Scalar>::real(a));
      const double d = static_cast<double>(A.diagonal(i)) * static_cast<double>(A.diagonal(j));
      if (w > 0 && w * w > threshold * threshold * d) visit(i, j, static_cast<float>(w));
    });
  };
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  internal::Connection_graph g;
  g.offsets.assign(at(A.size()) + 1, 0);
  for_each_connection([&](int i, int j, float) { ++g.offsets[at(i) + 1], ++g.offsets[at(j) + 1]; });
  for (int i = 0; i < A.size(); ++i) g.offsets[at(i) + 1] += g.offsets[at(i)];
  g.neighbors.resize(at(g.offsets.back()));
  g.weights.resize(g.neighbors.size());
  std::vector<int> next(g.offsets.begin(), g.offsets.end() - 1);
  const auto add = [&](int i, int j, float w) {
    const std::size_t k = at(next[at(i)]++);
    g.neighbors[k] = j;
    g.weights[k] = w;
  };
  for_each_connection([&](int i, int j, float w) { add(i, j, w), add(j, i, w); });
  return g;
}

}  // namespace Conformal_geometry_processing
