// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/hermitian_matrices.h"
#include "quaternionic_linear_algebra/spectral_problem.h"

#include <limits>

namespace cgp_test::eigensolver_result_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using Block = CGP::Block<Q>;

constexpr int n = 12;

class Ritz_panel : public testing::Test {
 protected:
  CGP::internal::Ritz_panel panel(const CGP::Block<Q>& v) const
  {
    return CGP::make_panel(CGP::block_operator(K), CGP::block_operator(N), v);
  }

  // Checks the invariant of a panel: v, K v, N v.
  void expect_consistent(const CGP::internal::Ritz_panel& p) const
  {
    EXPECT_LE((real_columns(p.kv) - real_form(K) * real_columns(p.v)).norm(), 1e-11);
    EXPECT_LE((real_columns(p.nv) - real_form(N) * real_columns(p.v)).norm(), 1e-11);
  }

  CGP::Hermitian_sparse_matrix<Q> K = random_hermitian<Q>(random_pattern(n, 1), 2);
  CGP::Hermitian_sparse_matrix<Q> N = random_definite<Q>(random_pattern(n, 3), 4);
};

double distance_to_identity(const CGP::Block<Q>& A)
{
  return (real_form(A) - Eigen::MatrixXd::Identity(4 * A.rows(), 4 * A.cols())).norm();
}

TEST_F(Ritz_panel, holds_what_k_and_n_make_of_the_vectors)
{
  auto p = panel(random_block<Q>(n, 3, 5));
  expect_consistent(p);
  p.v = random_block<Q>(n, 3, 6);
  CGP::apply_operators(CGP::block_operator(K), CGP::block_operator(N), p);
  expect_consistent(p);
}

TEST_F(Ritz_panel, can_be_replaced_by_a_combination_with_another)
{
  const auto q = panel(random_block<Q>(n, 2, 7));
  for (int columns = 0; columns <= 3; ++columns) {  // fewer than before, as many, or more
    auto p = panel(random_block<Q>(n, columns, 8));
    const auto C = random_block<Q>(columns, 2, 9), D = random_block<Q>(2, 2, 10);
    const Eigen::MatrixXd expected =
        real_columns(CGP::combination(p.v, C)) + real_columns(CGP::combination(q.v, D));
    CGP::replace_by_combination(p, C, q, D);
    EXPECT_LE((real_columns(p.v) - expected).norm(), 1e-13);
    expect_consistent(p);
  }
}

TEST_F(Ritz_panel, has_a_residual_orthogonal_to_the_vector)
{
  const auto p = panel(random_block<Q>(n, 1, 8));
  CGP::Block<Q> r;
  p.residual(r);
  EXPECT_LE(std::abs(CGP::inner_product(p.v.col(0), r.col(0)).w), 1e-13);
}

TEST_F(Ritz_panel, becomes_an_orthonormal_basis_of_the_same_span)
{
  const auto p = panel(random_block<Q>(n, 4, 9));
  auto basis = p;
  CGP::orthonormalize(basis);
  ASSERT_EQ(basis.size(), 4);
  expect_consistent(basis);
  EXPECT_LE(distance_to_identity(CGP::gram_matrix(basis.v, basis.nv)), 1e-13);
  const auto inside = CGP::combination(basis.v, CGP::gram_matrix(basis.nv, p.v));
  EXPECT_LE((real_columns(p.v) - real_columns(inside)).norm(), 1e-13);
}

TEST_F(Ritz_panel, loses_directions_that_depend_on_others)
{
  CGP::Block<Q> v = random_block<Q>(n, 5, 10);
  const Q q{0, 1, -2, 0.5};
  for (int i = 0; i < n; ++i) {
    v(i, 1) = v(i, 0) * q;               // over the quaternions the same direction
    v(i, 3) = v(i, 2) + 1e-8 * v(i, 3);  // nearly the same
    v(i, 4) = v(i, 2) + 1e-3 * v(i, 4);  // clearly another
  }
  auto p = panel(v), zero = panel(CGP::Block<Q>(n, 2));
  CGP::orthonormalize(p);
  CGP::orthonormalize(zero);
  EXPECT_EQ(p.size(), 3);
  expect_consistent(p);
  EXPECT_EQ(zero.size(), 0);
}

TEST(Orthonormal_combinations, depend_on_the_vectors_before_only)
{
  const auto V = random_block<Q>(n, 4, 11);
  const auto G = CGP::gram_matrix(V, V), C = CGP::internal::orthonormal_combinations(G);
  ASSERT_EQ(C.cols(), 4);
  EXPECT_LE(distance_to_identity(CGP::gram_matrix(C, CGP::combination(G, C))), 1e-13);
  for (int j = 0; j < 4; ++j)
    for (int i = j + 1; i < 4; ++i) EXPECT_EQ(CGP::norm(C(i, j)), 0);
}

TEST(Orthonormal_combinations, are_the_same_for_vectors_of_other_lengths)
{
  const auto V = random_block<Q>(n, 3, 11);
  auto W = V;
  const double lengths[] = {1e-150, 1, 1e100};
  for (int j = 0; j < 3; ++j) CGP::scale_column(W, j, lengths[j]);
  const auto of = [](const CGP::Block<Q>& v) {
    return CGP::combination(v, CGP::internal::orthonormal_combinations(CGP::gram_matrix(v, v)));
  };
  EXPECT_LE((real_columns(of(V)) - real_columns(of(W))).norm(), 1e-13);
}

TEST_F(Ritz_panel, over_the_reals_keeps_what_differs_by_a_quaternion)
{
  CGP::Block<Q> v = random_block<Q>(n, 3, 10);
  for (int i = 0; i < n; ++i) {
    v(i, 1) = v(i, 0) * Q{0, 1, -2, 0.5};
    v(i, 2) = 3. * v(i, 0) - v(i, 1);
  }
  auto p = CGP::make_panel(CGP::block_operator(K), CGP::block_operator(N), v,
                           CGP::internal::Coefficients::reals);
  CGP::orthonormalize(p);
  ASSERT_EQ(p.size(), 2);
  expect_consistent(p);
  const Eigen::MatrixXd gram = real_columns(p.v).transpose() * real_columns(p.nv);
  EXPECT_LE((gram - Eigen::MatrixXd::Identity(2, 2)).norm(), 1e-13);
  EXPECT_LE(distance_to_identity(p.gram(p.v, p.nv)), 1e-13);
}

// Feeds iterates of dimension two: the vector is (1, 0), the residual (0, size).
class Iteration {
 public:
  explicit Iteration(const CGP::Eigensolver_options& options = {})
      : m_convergence("run", options, Block(2, 1))
  {}

  bool is_last(double theta, double size)
  {
    const CGP::internal::Ritz_panel x = panel(theta);
    Block r(2, 1);
    r(1, 0).w = size;
    m_convergence.count_solve();
    const bool last = m_convergence.is_last(x, r, r, m_go_further);
    if (!last) m_convergence.count_iteration();
    return last;
  }

  bool has_adapted(double theta) { return m_convergence.has_adapted(panel(theta).v); }

  CGP::Eigensolver_result result() { return m_convergence.result(); }

 private:
  static CGP::internal::Ritz_panel panel(double theta)
  {
    CGP::internal::Ritz_panel x{Block(2, 1), Block(2, 1), Block(2, 1)};
    x.v(0, 0).w = x.nv(0, 0).w = 1;
    x.kv(0, 0).w = theta;
    return x;
  }

  CGP::internal::Eigensolver_convergence m_convergence;
  CGP::internal::Always_go_further m_go_further;
};

TEST(Eigensolver_convergence, stops_below_the_tolerance)
{
  Iteration run;
  EXPECT_FALSE(run.is_last(3, 1));
  EXPECT_FALSE(run.is_last(2, 1.1e-6));
  EXPECT_TRUE(run.is_last(1, 0.9e-6));
  const auto r = run.result();
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(r.iterations, 2);
  EXPECT_EQ(r.solves, 3);
  EXPECT_EQ(r.values[0], 1);
  EXPECT_NEAR(r.estimates[0], 0.9e-6, 1e-20);
  EXPECT_FALSE(r.gap.has_value());
}

TEST(Eigensolver_convergence, measures_in_the_given_scale)
{
  CGP::Eigensolver_options options;
  options.scale = 1e-3;
  Iteration run(options);
  EXPECT_FALSE(run.is_last(1, 1.1e-9));
  EXPECT_TRUE(run.is_last(1, 0.9e-9));
}

TEST(Eigensolver_convergence, keeps_the_best_iterate)
{
  CGP::Eigensolver_options options;
  options.max_iterations = 2;
  Iteration run(options);
  EXPECT_FALSE(run.is_last(5, 1e-3));
  EXPECT_FALSE(run.is_last(4, 1e-5));
  EXPECT_TRUE(run.is_last(3, 1e-4));
  const auto r = run.result();
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.values[0], 4);
  EXPECT_NEAR(r.estimates[0], 1e-5, 1e-18);
}

TEST(Eigensolver_convergence, sees_stagnation_after_three_steps_without_progress)
{
  Iteration run;
  EXPECT_FALSE(run.is_last(1, 1e-5));
  EXPECT_FALSE(run.is_last(1, 2e-5));
  EXPECT_FALSE(run.is_last(1, 1e-5));
  EXPECT_TRUE(run.is_last(1, 3e-5));
  EXPECT_TRUE(run.result().stagnated);
}

TEST(Eigensolver_convergence, waits_while_the_eigenvalue_still_falls)
{
  Iteration run;
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(run.is_last(2 - 0.01 * i, 1e-3 + 1e-5 * i));
}

TEST(Eigensolver_convergence, does_not_compare_iterates_of_different_matrices)
{
  CGP::Eigensolver_options options;
  double estimate = 0;
  bool changes = false;
  options.adapt = [&](const CGP::Eigensolver_progress& progress) {
    estimate = progress.estimate;
    return changes;
  };
  Iteration run(options);
  EXPECT_FALSE(run.is_last(1, 1e-5));
  EXPECT_FALSE(run.has_adapted(1));
  EXPECT_NEAR(estimate, 1e-5, 1e-18);
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(run.is_last(1, 2e-5));
  changes = true;
  EXPECT_TRUE(run.has_adapted(1));
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(run.is_last(5, 3e-5));  // no stagnation yet
  EXPECT_TRUE(run.is_last(5, 3e-5));
  const auto r = run.result();
  EXPECT_EQ(r.values[0], 5);
  EXPECT_NEAR(r.estimates[0], 3e-5, 1e-18);
}

TEST(Eigensolver_convergence, does_not_count_errors_along_the_vector)
{
  // T r = r + 1e6 x, as an inverse of a nearly singular matrix may give.
  const CGP::Eigensolver_options options;
  CGP::internal::Eigensolver_convergence convergence("run", options, Block(2, 1));
  CGP::internal::Ritz_panel x{Block(2, 1), Block(2, 1), Block(2, 1)};
  x.v(0, 0).w = x.nv(0, 0).w = x.kv(0, 0).w = 1;
  Block r(2, 1), Tr(2, 1);
  r(0, 0) = {1e-10, 1e-10, 0, 0};
  r(1, 0).w = Tr(1, 0).w = 1e-4;
  Tr(0, 0) = {1e6, 1e6, 0, 0};
  CGP::internal::Always_go_further always;
  EXPECT_FALSE(convergence.is_last(x, r, Tr, always));
  EXPECT_NEAR(convergence.result().estimates[0], 1e-4, 1e-16);
}

TEST(Eigensolver_convergence, refuses_values_that_are_not_finite)
{
  Iteration run;
  EXPECT_THROW(run.is_last(1, std::numeric_limits<double>::quiet_NaN()), CGP::Solver_error);
}

TEST(Eigensolver_convergence, refuses_fewer_vectors_than_wanted)
{
  CGP::Eigensolver_options options;
  options.wanted = 2;
  EXPECT_THROW(Iteration{options}, CGP::Precondition_error);
  options.wanted = 0;
  EXPECT_THROW(Iteration{options}, CGP::Precondition_error);
}

TEST(Eigensolver_result, starts_without_success)
{
  const CGP::Eigensolver_result r;
  EXPECT_FALSE(r.converged || r.stagnated || r.cancelled);
  EXPECT_EQ(r.iterations, 0);
}

}  // namespace cgp_test::eigensolver_result_tests
