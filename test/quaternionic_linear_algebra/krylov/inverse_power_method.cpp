// Tests krylov/inverse_power_method.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/krylov/inverse_power_method.h>

#include <gtest/gtest.h>

#include <cmath>

#include "quaternionic_linear_algebra/spectral_problem.h"

namespace cgp_test::inverse_power_method_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

CGP::Eigensolver_options options(double tolerance, int max_iterations)
{
  CGP::Eigensolver_options o;
  o.tolerance = tolerance;
  o.max_iterations = max_iterations;
  return o;
}

CGP::Eigensolver_result solve(const Spectral_problem& p, const CGP::Block<Q>& x0,
                              const CGP::Eigensolver_options& o)
{
  return CGP::inverse_power_method(p.k(), p.n(), p.inverse(), x0, o);
}

TEST(Inverse_power_method, gains_the_ratio_of_the_eigenvalues_in_every_step)
{
  // x = u_1 + u_2, after k steps proportional to u_1 + 2^-k u_2: tan = 2^-k.
  const Spectral_problem problem(counting(12));
  CGP::Block<Q> x0 = problem.vectors().leftCols(1);
  for (int i = 0; i < 12; ++i) x0(i, 0) += problem.vectors()(i, 1);
  for (int k = 1; k <= 8; ++k) {
    const auto r = solve(problem, x0, options(0, k));
    const double tangent = std::pow(0.5, k);
    EXPECT_EQ(r.iterations, k);
    EXPECT_NEAR(problem.sine(r.vectors), tangent / std::hypot(1, tangent), 1e-13);
    EXPECT_FALSE(r.converged);
  }
}

TEST(Inverse_power_method, normalises_by_the_masses)
{
  const Spectral_problem problem(counting(12));
  const auto r = solve(problem, random_block<Q>(12, 1, 2), options(0, 3));
  EXPECT_NEAR(CGP::inner_product(r.vectors.col(0), problem.masses(), r.vectors.col(0)).w, 1, 1e-14);
}

TEST(Inverse_power_method, finds_the_eigenvector_by_an_inexact_inverse)
{
  const Spectral_problem problem(counting(12));
  const auto exact = problem.inverse();
  const auto inexact = [&](const CGP::Block<Q>& b) {
    CGP::Block<Q> x;
    CGP::apply_operator(exact, b, x);
    for (Eigen::Index i = 0; i < x.size(); ++i) x(i) *= 1 + .05 * std::sin(7. * double(i));
    return x;
  };
  const auto r = CGP::inverse_power_method(problem.k(), problem.n(), inexact,
                                           random_block<Q>(12, 1, 3), options(1e-10, 200));
  EXPECT_TRUE(r.converged);
  EXPECT_LE(problem.sine(r.vectors), 1e-9);
}

TEST(Inverse_power_method, stops_at_the_tolerance)
{
  const Spectral_problem problem(counting(12));
  const auto r = solve(problem, random_block<Q>(12, 1, 3), options(1e-9, 100));
  EXPECT_TRUE(r.converged);
  EXPECT_NEAR(r.values[0], 1, 1e-13);
  EXPECT_LE(problem.sine(r.vectors), 1.5e-9);
}

TEST(Inverse_power_method, finds_a_subspace_with_several_columns)
{
  const Spectral_problem problem(counting(12));
  const auto r = solve(problem, random_block<Q>(12, 2, 4), options(1e-9, 200));
  EXPECT_TRUE(r.converged);
  EXPECT_NEAR(*r.gap, 1, 1e-3);
}

TEST(Inverse_power_method, refuses_dependent_initial_vectors)
{
  const Spectral_problem problem(counting(12));
  EXPECT_THROW(solve(problem, CGP::Block<Q>(12, 1), options(0, 1)), CGP::Precondition_error);
}

TEST(Inverse_power_method, stops_when_the_inverse_loses_a_column)
{
  const Spectral_problem problem(counting(12));
  const auto same = [](const CGP::Block<Q>& b) {
    return CGP::Block<Q>(CGP::Block<Q>::Constant(b.rows(), b.cols(), Q{1e20, 0, 0, 0}));
  };
  const auto r = CGP::inverse_power_method(problem.k(), problem.n(), same,
                                           random_block<Q>(12, 2, 5), options(-1, 10));
  EXPECT_TRUE(r.stagnated);
  EXPECT_EQ(r.iterations, 0);
}

TEST(Inverse_power_eigensolver_traits, use_a_matrix_and_its_factorization)
{
  const auto A = random_definite<Q>(random_pattern(30, 1), 2);
  const Eigen::VectorXd masses = Eigen::VectorXd::Ones(30);
  CGP::Eigen_hermitian_solver_traits::Solver<Q> solver;
  ASSERT_EQ(solver.analyze(A.pattern()), CGP::Solver_status::success);
  ASSERT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  const auto r = CGP::Inverse_power_eigensolver_traits{}(
      A, masses, solver, random_block<Q>(30, 1, 3), options(1e-8, 2000));
  ASSERT_TRUE(r.converged);
  const Eigen::MatrixXd X = real_columns(r.vectors);
  EXPECT_LE((real_form(A) * X - X * r.values[0]).norm(), 1e-6);
}

}  // namespace cgp_test::inverse_power_method_tests
