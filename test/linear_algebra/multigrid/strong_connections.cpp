// Tests include/Conformal_geometry_processing/linear_algebra/multigrid/strong_connections.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/multigrid/strong_connections.h>

#include <gtest/gtest.h>

#include <vector>

#include "linear_algebra/hermitian_matrices.h"

namespace cgp_test::strong_connections_tests {

using Ints = std::vector<int>;
using Floats = std::vector<float>;

/// the path 0 - 1 - 2 - 3 with diagonal 4 and the given entries
template <class Scalar>
CGP::Hermitian_sparse_matrix<Scalar> path(const std::vector<Scalar>& entries)
{
  CGP::Hermitian_sparse_matrix<Scalar> A(pattern_of_edges(4, {{0, 1}, {1, 2}, {2, 3}}));
  for (int j = 0; j < 4; ++j) {
    const int k = A.pattern().offsets[at(j)];
    A.value(k) = CGP::internal::Scalar_traits<Scalar>::from_real(4);
    if (j < 3) A.value(k + 1) = entries[at(j)];
  }
  return A;
}

TEST(Strong_connections, are_negative_entries_with_both_ends)
{
  const CGP::internal::Connection_graph g = CGP::strong_connections(path<double>({-1, -2, -3}), 0);
  EXPECT_EQ(g.size(), 4);
  EXPECT_EQ(g.offsets, (Ints{0, 1, 3, 5, 6}));
  EXPECT_EQ(g.neighbors, (Ints{1, 0, 2, 1, 3, 2}));
  EXPECT_EQ(g.weights, (Floats{1, 1, 2, 2, 3, 3}));
}

TEST(Strong_connections, are_not_positive_or_zero_entries)
{
  const CGP::internal::Connection_graph g = CGP::strong_connections(path<double>({1, 0, -3}), 0);
  EXPECT_EQ(g.offsets, (Ints{0, 0, 0, 1, 2}));
  EXPECT_EQ(g.neighbors, (Ints{3, 2}));
}

TEST(Strong_connections, are_larger_than_the_threshold_times_the_diagonal)
{
  const CGP::internal::Connection_graph g =
      CGP::strong_connections(path<double>({-1.9, -2, -2.1}), .5);
  EXPECT_EQ(g.neighbors, (Ints{3, 2}));
}

TEST(Strong_connections, of_quaternions_are_those_of_the_real_part)
{
  using Q = Quaternion<double>;
  const CGP::internal::Connection_graph g =
      CGP::strong_connections(path<Q>({{-1, 3, 0, 0}, {1, -3, -3, -3}, {-2, 0, 0, 5}}), .2);
  EXPECT_EQ(g.neighbors, (Ints{1, 0, 3, 2}));
  EXPECT_EQ(g.weights, (Floats{1, 1, 2, 2}));
}

TEST(Strong_connections, have_ascending_neighbors)
{
  const auto L = random_laplacian(random_pattern(60, 1), 2);
  const CGP::internal::Connection_graph g = CGP::strong_connections(L, 0);
  EXPECT_EQ(g.neighbors.size(), 2 * (L.pattern().indices.size() - 60));
  for (int i = 0; i < g.size(); ++i)
    for (int k = g.begin(i); k < g.end(i); ++k) {
      EXPECT_LT(k > g.begin(i) ? g.neighbor(k - 1) : -1, g.neighbor(k));
      EXPECT_EQ(g.weight(k), static_cast<float>(-L.coefficient(i, g.neighbor(k))));
    }
}

}  // namespace cgp_test::strong_connections_tests
