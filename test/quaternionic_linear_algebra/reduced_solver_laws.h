// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "quaternionic_linear_algebra/reduced_problem.h"

/// What every solver for reduced systems does; instantiate over solver types.
namespace cgp_test {

using CGP::Solver_status;

template <class Solver_>
class Reduced_solver : public testing::Test {
 protected:
  using Solver = Solver_;
  using Q = Quaternion<double>;

  Solver_status analyze(const Reduced_problem& p, std::uint64_t seed = 1)
  {
    return solver.analyze(p.X.pattern(), p.rows(), random_permutation(p.X.size(), seed));
  }

  Solver_status factorize(const Reduced_problem& p)
  {
    return solver.factorize(p.X, p.shift, p.basis());
  }

  void expect_solves(const Reduced_problem& p, int columns)
  {
    const auto b = random_block<Q>(p.X.size(), columns, 77);
    CGP::Block<Q> x;
    ASSERT_EQ(solver.solve(b, x), Solver_status::success);
    const Eigen::MatrixXd expected = p.dense_solution(b);
    EXPECT_LE((real_columns(x) - expected).norm(), 1e-11 * expected.norm());
  }

  void expect_works(const Reduced_problem& p)
  {
    ASSERT_EQ(analyze(p), Solver_status::success);
    ASSERT_EQ(factorize(p), Solver_status::success);
    expect_solves(p, 1);
    expect_solves(p, 5);
  }

  Reduced_problem problem = reduced_problem(disk(4), 1);
  Solver solver;
};

TYPED_TEST_SUITE_P(Reduced_solver);

TYPED_TEST_P(Reduced_solver, solves_on_disks_and_annuli)
{
  this->expect_works(this->problem);
  this->expect_works(reduced_problem(annulus(1, 2, 12, 5), 2));
  this->expect_works(reduced_problem(cap_from_disk(disk(3), 1), 3));
}

TYPED_TEST_P(Reduced_solver, solves_where_no_row_or_every_row_is_reduced)
{
  const Pattern pattern = random_pattern(20, 4);
  std::vector<int> all(20);
  std::iota(all.begin(), all.end(), 0);
  this->expect_works(reduced_problem(pattern, {}, 5));
  this->expect_works(reduced_problem(pattern, all, 6));
  this->expect_works(reduced_problem(single_triangle(), 7));
}

TYPED_TEST_P(Reduced_solver, solves_where_reduced_rows_cut_the_others_in_pieces)
{
  // A path with every third row reduced, a reduced row alone, and two rows without a reduced one.
  std::vector<std::pair<int, int>> edges = {{31, 32}};
  for (int i = 0; i + 1 < 30; ++i) edges.push_back({i, i + 1});
  const Pattern pattern = pattern_of_edges(33, edges);
  this->expect_works(reduced_problem(pattern, {1, 4, 7, 10, 13, 16, 19, 22, 25, 28, 30}, 8));
}

TYPED_TEST_P(Reduced_solver, solves_where_reduced_rows_lie_anywhere_in_a_graph)
{
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const int n = 60;
    std::vector<int> rows = random_permutation(n, seed);
    rows.resize(at(7 + 10 * static_cast<int>(seed)));
    this->expect_works(reduced_problem(random_pattern(n, seed), rows, 10 + seed));
  }
}

TYPED_TEST_P(Reduced_solver, solves_where_many_rows_are_reduced)
{
  // More than a supernode is wide.
  std::vector<int> rows = random_permutation(180, 11);
  rows.resize(100);
  this->expect_works(reduced_problem(random_pattern(180, 12), rows, 13));
}

TYPED_TEST_P(Reduced_solver, factorizes_again_with_other_values_and_planes)
{
  ASSERT_EQ(this->analyze(this->problem), Solver_status::success);
  for (std::uint64_t seed = 20; seed < 23; ++seed) {
    const auto pattern = this->problem.X.shared_pattern();
    const Reduced_problem p = reduced_problem(pattern, this->problem.reduced, seed);
    ASSERT_EQ(this->factorize(p), Solver_status::success);
    this->expect_solves(p, 2);
  }
}

TYPED_TEST_P(Reduced_solver, gives_solutions_that_lie_in_the_reduced_space)
{
  const Reduced_problem& p = this->problem;
  ASSERT_EQ(this->analyze(p), Solver_status::success);
  ASSERT_EQ(this->factorize(p), Solver_status::success);
  CGP::Block<Quaternion<double>> x;
  ASSERT_EQ(this->solver.solve(random_block<Quaternion<double>>(p.X.size(), 2, 23), x),
            Solver_status::success);
  EXPECT_LE((real_columns(p.basis().project(x)) - real_columns(x)).norm(),
            1e-14 * real_columns(x).norm());
}

TYPED_TEST_P(Reduced_solver, is_real_linear)
{
  ASSERT_EQ(this->analyze(this->problem), Solver_status::success);
  ASSERT_EQ(this->factorize(this->problem), Solver_status::success);
  const auto b = random_block<Quaternion<double>>(this->problem.X.size(), 2, 24);
  const Eigen::VectorXd combined = real_columns(b) * Eigen::Vector2d(0.7, -1.9);
  CGP::Block<Quaternion<double>> c(b.rows(), 1), x, y;
  for (Eigen::Index i = 0; i < b.rows(); ++i) c(i, 0) = b(i, 0) * 0.7 - b(i, 1) * 1.9;
  ASSERT_EQ(this->solver.solve(b, x), Solver_status::success);
  ASSERT_EQ(this->solver.solve(c, y), Solver_status::success);
  EXPECT_LE((real_columns(x) * Eigen::Vector2d(0.7, -1.9) - real_columns(y)).norm(),
            1e-11 * real_columns(y).norm());
}

TYPED_TEST_P(Reduced_solver, gives_the_same_bits_twice)
{
  const auto b = random_block<Quaternion<double>>(this->problem.X.size(), 3, 25);
  CGP::Block<Quaternion<double>> x[3];
  ASSERT_EQ(this->analyze(this->problem), Solver_status::success);
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(this->factorize(this->problem), Solver_status::success);
    ASSERT_EQ(this->solver.solve(b, x[i]), Solver_status::success);
  }
  TypeParam other;
  ASSERT_EQ(other.analyze(this->problem.X.pattern(), this->problem.rows(),
                          random_permutation(this->problem.X.size(), 1)),
            Solver_status::success);
  ASSERT_EQ(other.factorize(this->problem.X, this->problem.shift, this->problem.basis()),
            Solver_status::success);
  ASSERT_EQ(other.solve(b, x[2]), Solver_status::success);
  EXPECT_EQ(real_columns(x[0]), real_columns(x[1]));
  EXPECT_EQ(real_columns(x[0]), real_columns(x[2]));
}

TYPED_TEST_P(Reduced_solver, reports_indefinite_matrices_and_recovers)
{
  ASSERT_EQ(this->analyze(this->problem), Solver_status::success);
  const int interior = 0, boundary = this->problem.reduced.front();
  for (const int row : {interior, boundary}) {
    Reduced_problem bad = this->problem;
    bad.shift[row] = -3 * bad.X.diagonal(row);
    EXPECT_EQ(this->factorize(bad), Solver_status::not_positive_definite);
    CGP::Block<Quaternion<double>> x;
    EXPECT_EQ(this->solver.solve(random_block<Quaternion<double>>(bad.X.size(), 1, 26), x),
              Solver_status::wrong_state);
  }
  ASSERT_EQ(this->factorize(this->problem), Solver_status::success);
  this->expect_solves(this->problem, 1);
}

TYPED_TEST_P(Reduced_solver, needs_the_reduced_matrix_alone_to_be_definite)
{
  // X = (1, -1)-indefinite on H^2: on the plane of row 1, X is positive definite.
  const Pattern pattern = pattern_of_edges(2, {{0, 1}});
  CGP::Hermitian_sparse_matrix<Quaternion<double>> X(pattern);
  X.value(0) = {1, 0, 0, 0};
  X.value(1) = {0, 2, 0, 0};  // |X_10|^2 > X_00 X_11
  X.value(2) = {1, 0, 0, 0};
  const Reduced_problem all{X, Eigen::VectorXd::Zero(2), {}, {}};
  ASSERT_EQ(this->analyze(all), Solver_status::success);
  EXPECT_EQ(this->factorize(all), Solver_status::not_positive_definite);
  const Quaternion<double> i{0, 1, 0, 0}, k{0, 0, 0, 1}, one{1, 0, 0, 0}, j{0, 0, 1, 0};
  const Reduced_problem both{X, Eigen::VectorXd::Zero(2), {0, 1}, {{one, j}, {one, j}}};
  ASSERT_EQ(this->analyze(both), Solver_status::success);
  ASSERT_EQ(this->factorize(both), Solver_status::success);
  this->expect_solves(both, 1);
  const Reduced_problem turned{X, Eigen::VectorXd::Zero(2), {0, 1}, {{one, j}, {i, k}}};
  EXPECT_EQ(this->factorize(turned), Solver_status::not_positive_definite);
}

TYPED_TEST_P(Reduced_solver, reports_values_that_are_not_finite)
{
  ASSERT_EQ(this->analyze(this->problem), Solver_status::success);
  const int boundary = this->problem.reduced.front();
  const int entries[] = {0, 1, this->problem.X.pattern().offsets[at(boundary)],
                         this->problem.X.pattern().size_of_entries() - 1};
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (const int k : entries) {
      Reduced_problem p = this->problem;
      p.X.value(k) = {bad, 0, 0, 0};
      EXPECT_EQ(this->factorize(p), Solver_status::numerical_issue);
    }
    for (const int i : {0, boundary}) {
      Reduced_problem p = this->problem;
      p.shift[i] = bad;
      EXPECT_EQ(this->factorize(p), Solver_status::numerical_issue);
    }
  }
}

TYPED_TEST_P(Reduced_solver, refuses_calls_in_the_wrong_order)
{
  const auto b = random_block<Quaternion<double>>(this->problem.X.size(), 1, 27);
  CGP::Block<Quaternion<double>> x;
  EXPECT_EQ(this->factorize(this->problem), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
  ASSERT_EQ(this->analyze(this->problem), Solver_status::success);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
}

TYPED_TEST_P(Reduced_solver, refuses_what_has_another_size)
{
  const Reduced_problem& p = this->problem;
  EXPECT_EQ(this->solver.analyze(p.X.pattern(), p.rows(), {0, 1, 2}), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.analyze(p.X.pattern(), CGP::internal::Reduced_rows(3, {1}),
                                 random_permutation(p.X.size(), 1)),
            Solver_status::wrong_state);
  EXPECT_EQ(this->solver.analyze(CGP::Sparse_pattern{}, CGP::internal::Reduced_rows(),
                                 CGP::internal::Ordering{}),
            Solver_status::wrong_state);
  ASSERT_EQ(this->analyze(p), Solver_status::success);
  EXPECT_EQ(this->factorize(reduced_problem(disk(3), 1)), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.factorize(p.X, Eigen::VectorXd(3), p.basis()), Solver_status::wrong_state);
  const CGP::internal::Reduced_basis<double> fewer(p.X.size(), {p.reduced[0]}, {p.planes[0]});
  EXPECT_EQ(this->solver.factorize(p.X, p.shift, fewer), Solver_status::wrong_state);
  ASSERT_EQ(this->factorize(p), Solver_status::success);
  CGP::Block<Quaternion<double>> x;
  EXPECT_EQ(this->solver.solve(random_block<Quaternion<double>>(3, 1, 28), x),
            Solver_status::wrong_state);
}

TYPED_TEST_P(Reduced_solver, gives_its_memory_back_and_factorizes_again)
{
  const auto b = random_block<Quaternion<double>>(this->problem.X.size(), 1, 29);
  CGP::Block<Quaternion<double>> before, after;
  this->solver.release();
  ASSERT_EQ(this->analyze(this->problem), Solver_status::success);
  ASSERT_EQ(this->factorize(this->problem), Solver_status::success);
  ASSERT_EQ(this->solver.solve(b, before), Solver_status::success);
  this->solver.release();
  EXPECT_EQ(this->solver.solve(b, after), Solver_status::wrong_state);
  ASSERT_EQ(this->factorize(this->problem), Solver_status::success);
  ASSERT_EQ(this->solver.solve(b, after), Solver_status::success);
  EXPECT_EQ(real_columns(after), real_columns(before));
}

TYPED_TEST_P(Reduced_solver, tells_the_cost)
{
  EXPECT_EQ(this->solver.statistics().factor_entries, 0);
  ASSERT_EQ(this->analyze(this->problem), Solver_status::success);
  const CGP::Solver_statistics s = this->solver.statistics();
  EXPECT_GE(s.factor_entries, this->problem.X.size());
  EXPECT_GE(s.flops, static_cast<double>(s.factor_entries));
  EXPECT_GE(s.bytes, static_cast<double>(s.factor_entries) * sizeof(double));
}

REGISTER_TYPED_TEST_SUITE_P(
    Reduced_solver, solves_on_disks_and_annuli, solves_where_no_row_or_every_row_is_reduced,
    solves_where_reduced_rows_cut_the_others_in_pieces,
    solves_where_reduced_rows_lie_anywhere_in_a_graph, solves_where_many_rows_are_reduced,
    factorizes_again_with_other_values_and_planes, gives_solutions_that_lie_in_the_reduced_space,
    is_real_linear, gives_the_same_bits_twice, reports_indefinite_matrices_and_recovers,
    needs_the_reduced_matrix_alone_to_be_definite, reports_values_that_are_not_finite,
    refuses_calls_in_the_wrong_order, refuses_what_has_another_size,
    gives_its_memory_back_and_factorizes_again, tells_the_cost);

}  // namespace cgp_test
