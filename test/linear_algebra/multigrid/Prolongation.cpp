// Tests include/Conformal_geometry_processing/linear_algebra/multigrid/Prolongation.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/multigrid/Prolongation.h>

#include <gtest/gtest.h>

#include "linear_algebra/multigrid_tools.h"

namespace cgp_test::prolongation_tests {

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

}  // namespace cgp_test::prolongation_tests
