// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/multigrid/Prolongation.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/graphs.h"
#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "quaternionic_linear_algebra/multigrid_tools.h"
#include "support/spheres.h"

#include <queue>
#include <vector>

namespace cgp_test::prolongation_tests {

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

CGP::internal::Connection_graph connections(const CGP::Sparse_pattern& pattern)
{
  const auto L = random_laplacian(std::make_shared<const CGP::Sparse_pattern>(pattern), 5);
  return CGP::strong_connections(L, 0);
}

/// the number of vertices that are reached from `start` within its aggregate
int reached(const CGP::internal::Connection_graph& g, const CGP::internal::Aggregation& a,
            int start)
{
  std::vector<bool> is_reached(at(g.size()));
  std::queue<int> queue;
  const auto reach = [&](int i) {
    if (is_reached[at(i)] || a.aggregate_of[at(i)] != a.aggregate_of[at(start)]) return;
    is_reached[at(i)] = true;
    queue.push(i);
  };
  reach(start);
  int count = 0;
  for (; !queue.empty(); queue.pop(), ++count)
    for (int k = g.begin(queue.front()); k < g.end(queue.front()); ++k) reach(g.neighbor(k));
  return count;
}

TEST(Aggregate, groups_a_path_by_threes)
{
  // The first vertex has one neighbor; the last but one is left over.
  const CGP::internal::Aggregation a = CGP::aggregate(connections(pattern_of(9, path_edges(9))));
  EXPECT_EQ(a.size, 3);
  EXPECT_EQ(a.aggregate_of, (Ints{0, 0, 1, 1, 1, 2, 2, 2, 2}));
}

TEST(Aggregate, joins_what_is_left_over_where_the_connection_is_strongest)
{
  // The path 0 - 1 - 2 - 4 - 3 in which 2 is left over between 1 and 4.
  CGP::internal::Connection_graph g{
      {0, 1, 3, 5, 6, 8}, {1, 0, 2, 1, 4, 4, 2, 3}, {9, 9, 2, 2, 1, 9, 1, 9}};
  EXPECT_EQ(CGP::aggregate(g).aggregate_of, (Ints{0, 0, 0, 1, 1}));
  std::swap(g.weights[2], g.weights[4]);
  std::swap(g.weights[3], g.weights[6]);
  EXPECT_EQ(CGP::aggregate(g).aggregate_of, (Ints{0, 0, 1, 1, 1}));
}

TEST(Aggregate, leaves_vertices_without_connections_alone)
{
  const CGP::internal::Aggregation a = CGP::aggregate(connections(pattern_of(6, {{1, 4}})));
  EXPECT_EQ(a.size, 1);
  EXPECT_EQ(a.aggregate_of, (Ints{-1, 0, -1, -1, 0, -1}));
}

TEST(Aggregate, gives_connected_groups_of_two_or_more_for_graphs_of_all_kinds)
{
  for (const Named_graph& graph : graphs_of_all_kinds()) {
    if (graph.size == 0) continue;
    const CGP::internal::Connection_graph g = connections(pattern_of(graph.size, graph.edges));
    const CGP::internal::Aggregation a = CGP::aggregate(g);
    Ints sizes(at(a.size), 0);
    for (int i = 0; i < g.size(); ++i) {
      const int of = a.aggregate_of[at(i)];
      ASSERT_EQ(of < 0, g.begin(i) == g.end(i)) << graph.name;
      ASSERT_LT(of, a.size) << graph.name;
      if (of >= 0) ++sizes[at(of)];
    }
    for (int i = 0; i < g.size(); ++i)
      if (const int of = a.aggregate_of[at(i)]; of >= 0) {
        ASSERT_GE(sizes[at(of)], 2) << graph.name;
        ASSERT_EQ(i % 7 == 0 ? reached(g, a, i) : sizes[at(of)], sizes[at(of)]) << graph.name;
      }
  }
}

TEST(Aggregate, makes_groups_of_about_nine_on_triangle_meshes)
{
  const Mesh_view mesh = geodesic_sphere(20);
  const CGP::internal::Aggregation a = CGP::aggregate(connections(pattern_of(mesh)));
  EXPECT_GT(mesh.size_of_vertices(), 7 * a.size);
  EXPECT_LT(mesh.size_of_vertices(), 12 * a.size);
}

/// a connected graph of 200 vertices, of which 7 are then cut off
CGP::internal::Connection_graph graph_with_isolated_vertices()
{
  auto L = random_laplacian(random_pattern(200, 3), 4);
  for (int j = 0; j < L.size(); ++j)
    for (int k = L.pattern().offsets[at(j)] + 1; k < L.pattern().offsets[at(j) + 1]; ++k)
      if (j % 30 == 0 || L.pattern().indices[at(k)] % 30 == 0) L.value(k) = 0;
  return CGP::strong_connections(L, 0);
}

const CGP::internal::Connection_graph graph = graph_with_isolated_vertices();
const CGP::internal::Aggregation aggregation = CGP::aggregate(graph);

TEST(Prolongation, without_smoothing_is_constant_on_aggregates)
{
  const CGP::internal::Prolongation P = CGP::smoothed_prolongation(graph, aggregation, 0);
  const Eigen::MatrixXd D = real_form(P);
  EXPECT_EQ(D.rows(), 200);
  EXPECT_EQ(D.cols(), aggregation.size);
  for (int i = 0; i < 200; ++i)
    for (int I = 0; I < aggregation.size; ++I)
      EXPECT_EQ(D(i, I), aggregation.aggregate_of[at(i)] == I ? 1 : 0);
}

TEST(Prolongation, is_smoothed_by_one_step_of_jacobi)
{
  const double omega = 0.7;
  const Eigen::MatrixXd P0 = real_form(CGP::smoothed_prolongation(graph, aggregation, 0));
  Eigen::MatrixXd W = Eigen::MatrixXd::Zero(200, 200);
  for (int i = 0; i < 200; ++i)
    for (int k = graph.begin(i); k < graph.end(i); ++k)
      W(i, graph.neighbor(k)) = static_cast<double>(graph.weight(k));
  const Eigen::VectorXd sums = W.rowwise().sum().cwiseMax(1e-300);
  const Eigen::MatrixXd expected = (1 - omega) * P0 + omega * sums.asDiagonal().inverse() * W * P0;
  const CGP::internal::Prolongation P = CGP::smoothed_prolongation(graph, aggregation, omega);
  EXPECT_LT((real_form(P) - expected).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Prolongation, carries_constants_over_and_has_no_negative_entry)
{
  const CGP::internal::Prolongation P = CGP::smoothed_prolongation(graph, aggregation, .8);
  for (int i = 0; i < 200; ++i) {
    double sum = 0;
    P.for_each_in_row(i, [&](int, float weight) {
      EXPECT_GE(weight, 0);
      sum += static_cast<double>(weight);
    });
    const bool is_isolated = graph.begin(i) == graph.end(i);
    EXPECT_NEAR(sum, is_isolated ? 0 : 1, 1e-6);
    EXPECT_EQ(is_isolated, P.offsets[at(i)] == P.offsets[at(i) + 1]);
  }
}

TEST(Prolongation, names_every_column_once_in_a_row)
{
  const CGP::internal::Prolongation P = CGP::smoothed_prolongation(graph, aggregation, .8);
  for (int i = 0; i < 200; ++i) {
    std::set<int> columns;
    P.for_each_in_row(i, [&](int I, float) { EXPECT_TRUE(columns.insert(I).second); });
  }
  EXPECT_EQ(P.bytes(), 4 * (201 + 2 * P.columns.size()));
}

template <class Scalar>
class Galerkin_product : public testing::Test {};
using Scalars = testing::Types<double, Quaternion<double>>;
TYPED_TEST_SUITE(Galerkin_product, Scalars);

CGP::internal::Prolongation prolongation(const Pattern& pattern)
{
  const CGP::internal::Connection_graph g =
      CGP::strong_connections(random_laplacian(pattern, 2), 0);
  return CGP::smoothed_prolongation(g, CGP::aggregate(g), .8);
}

TYPED_TEST(Galerkin_product, is_the_dense_product)
{
  for (const Pattern& pattern : {random_pattern(90, 1), grid_pattern(9, 8), full_pattern(6),
                                 pattern_of_edges(7, {{0, 1}, {3, 5}})}) {
    const auto A = random_hermitian<TypeParam>(pattern, 3);
    const CGP::internal::Prolongation P = prolongation(pattern);
    const auto C = CGP::galerkin_product(A, P);
    const Eigen::MatrixXd D = real_form(P, planes_of<TypeParam>);
    const Eigen::MatrixXd expected = D.transpose() * real_form(A) * D;
    ASSERT_EQ(C.size(), P.coarse_size);
    EXPECT_LT((real_form(C) - expected).cwiseAbs().maxCoeff(), 1e-14 * pattern->size());
  }
}

TYPED_TEST(Galerkin_product, has_a_pattern_in_order_and_a_real_diagonal)
{
  const Pattern pattern = random_pattern(300, 4);
  const auto A = random_hermitian<TypeParam>(pattern, 5);
  const auto C = CGP::galerkin_product(A, prolongation(pattern));
  const CGP::Sparse_pattern& p = C.pattern();
  ASSERT_EQ(p.offsets.front(), 0);
  ASSERT_EQ(p.offsets.back(), p.size_of_entries());
  for (int j = 0; j < C.size(); ++j) {
    const int begin = p.offsets[at(j)], end = p.offsets[at(j) + 1];
    ASSERT_LT(begin, end);
    ASSERT_EQ(p.indices[at(begin)], j);
    for (int k = begin + 1; k < end; ++k) ASSERT_LT(p.indices[at(k - 1)], p.indices[at(k)]);
    EXPECT_EQ(C.value(begin), CGP::internal::Scalar_traits<TypeParam>::from_real(C.diagonal(j)));
  }
}

TYPED_TEST(Galerkin_product, without_coarse_vertices_is_empty)
{
  const Pattern pattern = pattern_of_edges(5, {});
  const auto C =
      CGP::galerkin_product(random_hermitian<TypeParam>(pattern, 6), prolongation(pattern));
  EXPECT_EQ(C.size(), 0);
}

TYPED_TEST(Galerkin_product, gives_the_same_bits_twice)
{
  const Pattern pattern = random_pattern(300, 7);
  const auto A = single(random_hermitian<TypeParam>(pattern, 8));
  const CGP::internal::Prolongation P = prolongation(pattern);
  const auto C = CGP::galerkin_product(A, P), D = CGP::galerkin_product(A, P);
  ASSERT_EQ(C.pattern(), D.pattern());
  for (int k = 0; k < C.pattern().size_of_entries(); ++k) EXPECT_EQ(C.value(k), D.value(k));
}

}  // namespace cgp_test::prolongation_tests
