// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/krylov/subspace_iteration.h>

#include <gtest/gtest.h>

#include "support/random.h"

#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

namespace cgp_test::subspace_iteration_tests {

namespace CGP = Conformal_geometry_processing;

Eigen::MatrixXcd random_block(int rows, int columns, std::uint64_t seed)
{
  Eigen::MatrixXcd x(rows, columns);
  for (int k = 0; k < columns; ++k) {
    x.col(k).real() = random_numbers(rows, seed + static_cast<std::uint64_t>(2 * k));
    x.col(k).imag() = random_numbers(rows, seed + static_cast<std::uint64_t>(2 * k) + 1);
  }
  return x;
}

Eigen::VectorXd half_of_them(int n)
{
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(n);
  for (int i = 0; i < n; i += 2) weights[i] = 1 + i;
  return weights;
}

TEST(Centered_mass, is_the_spread_around_the_weighted_mean)
{
  const int n = 10;
  const Eigen::VectorXd w = half_of_them(n);
  const CGP::internal::Centered_mass<std::complex<double>> mass(w, Eigen::MatrixXcd::Ones(n, 1));
  const Eigen::VectorXcd x = random_block(n, 1, 1);
  const std::complex<double> mean = w.cast<std::complex<double>>().dot(x) / w.sum();
  const double spread = w.dot((x.array() - mean).abs2().matrix());
  const Eigen::VectorXcd y = mass * x;
  EXPECT_NEAR(std::abs(x.dot(y) - spread), 0, 1e-13 * spread);
  EXPECT_LT((mass * Eigen::MatrixXcd::Ones(n, 1)).norm(), 1e-13);
}

TEST(Centered_mass, makes_columns_orthonormal)
{
  const int n = 10;
  const CGP::internal::Centered_mass<std::complex<double>> mass(half_of_them(n),
                                                                Eigen::MatrixXcd::Ones(n, 1));
  Eigen::MatrixXcd x = random_block(n, 3, 7);
  x.col(2) = x.col(0) + 1e-7 * x.col(2);  // nearly dependent
  const Eigen::VectorXcd first = x.col(0);
  mass.orthonormalize(x);
  EXPECT_LT((x.adjoint() * (mass * x) - Eigen::MatrixXcd::Identity(3, 3)).norm(), 1e-12);
  EXPECT_LT((x.col(0).normalized() - first.normalized()).norm(), 1e-13);
}

/// the Laplacian of a path: eigenvalues 2 - 2 cos(pi k / n), vectors cos(pi k (i + 1/2) / n)
CGP::Hermitian_sparse_matrix<double> path(int n)
{
  std::vector<std::vector<int>> columns(at(n));
  for (int i = 0; i + 1 < n; ++i) columns[at(i)].push_back(i + 1);
  const auto pattern = CGP::sparse_pattern(std::move(columns));
  CGP::Hermitian_sparse_matrix<double> L(pattern);
  for (int i = 0; i + 1 < n; ++i) {
    L.value(pattern->find(i, i)) += 1;
    L.value(pattern->find(i + 1, i + 1)) += 1;
    L.value(pattern->find(i + 1, i)) -= 1;
  }
  return L;
}

struct Path_problem {
  explicit Path_problem(int n)
      : L(path(n)), mass(Eigen::VectorXd::Ones(n), Eigen::MatrixXd::Ones(n, 1))
  {
    EXPECT_EQ(solver.analyze(L.pattern()), CGP::Solver_status::success);
    EXPECT_EQ(solver.factorize(L, Eigen::VectorXd::Constant(n, shift)),
              CGP::Solver_status::success);
  }

  CGP::internal::Subspace_result<double> solve(int vectors, double tolerance,
                                               int iterations = 100) const
  {
    Eigen::MatrixXd x(L.size(), vectors);
    for (int k = 0; k < vectors; ++k)
      x.col(k) = random_numbers(L.size(), static_cast<std::uint64_t>(k) + 1);
    return CGP::subspace_iteration(L, mass, shift, solver, x, {tolerance, iterations});
  }

  double shift = 1e-10;
  CGP::Hermitian_sparse_matrix<double> L;
  CGP::internal::Centered_mass<double> mass;
  CGP::internal::Solver_ref<double> solver;
};

TEST(Subspace_iteration, finds_the_slowest_mode_of_a_path)
{
  const int n = 40;
  const auto result = Path_problem(n).solve(3, 1e-10);
  ASSERT_TRUE(result.converged);
  EXPECT_NEAR(result.eigenvalue, 2 - 2 * std::cos(pi / n), 1e-14);
  EXPECT_NEAR(result.next_eigenvalue, 2 - 2 * std::cos(2 * pi / n), 1e-8);
  const Eigen::VectorXd centred = result.vector.array() - result.vector.mean();
  for (int i = 0; i < n; ++i)
    EXPECT_NEAR(centred[i] / centred[0], std::cos(pi * (i + .5) / n) / std::cos(pi * .5 / n),
                1e-10);
  EXPECT_NEAR(centred.norm(), 1, 1e-14);
}

TEST(Subspace_iteration, is_faster_with_more_vectors)
{
  const Path_problem problem(40);
  EXPECT_LT(problem.solve(4, 1e-8).iterations + 4, problem.solve(1, 1e-8).iterations);
}

TEST(Subspace_iteration, estimates_the_error_that_it_has)
{
  const int n = 40;
  const Path_problem problem(n);
  Eigen::VectorXd exact(n);
  for (int i = 0; i < n; ++i) exact[i] = std::cos(pi * (i + .5) / n);
  exact.normalize();
  const double mu = 2 - 2 * std::cos(pi / n);
  for (const int iterations : {3, 5}) {
    const auto before = problem.solve(1, 0, iterations - 1),
               after = problem.solve(1, 0, iterations);
    const Eigen::VectorXd error = before.vector - exact * exact.dot(before.vector);
    const double energy = std::sqrt(error.dot(problem.L * error) / mu);
    EXPECT_GT(after.residual, energy / 2);
    EXPECT_LT(after.residual, energy * 2);
  }
}

TEST(Subspace_iteration, ends_when_it_has_to)
{
  const auto result = Path_problem(40).solve(1, 1e-14, 2);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 2);
}

TEST(Subspace_iteration, hands_on_the_failure_of_a_solver)
{
  const Path_problem problem(4);
  const CGP::internal::Solver_ref<double> not_ready;
  const auto result = CGP::subspace_iteration(problem.L, problem.mass, 1e-10, not_ready,
                                              Eigen::MatrixXd(Eigen::VectorXd::LinSpaced(4, 0, 1)));
  EXPECT_EQ(result.status, CGP::Solver_status::wrong_state);
  EXPECT_FALSE(result.converged);
}

}  // namespace cgp_test::subspace_iteration_tests
