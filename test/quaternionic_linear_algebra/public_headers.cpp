// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests direct_solvers.h eigensolvers.h settings.h
// Tests iterative_solvers.h
#include <Quaternionic_linear_algebra/direct_solvers.h>
#include <Quaternionic_linear_algebra/eigensolvers.h>
#include <Quaternionic_linear_algebra/iterative_solvers.h>
#include <Quaternionic_linear_algebra/settings.h>

#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace cgp_test::public_headers_tests {

namespace CGP = Conformal_geometry_processing;
using Quaternion = CGP::Quaternion<double>;
using Matrix = CGP::Hermitian_sparse_matrix<Quaternion>;
constexpr int n = 60;

// G^H L G for the Laplacian L of a path with fixed ends and unit quaternions G: has the eigenvalues
// of L, which are 2 - 2 cos(k pi / (n + 1)).
Matrix turned_path()
{
  const auto g = CGP::random_quaternions(n, 1, 7);
  std::vector<std::vector<int>> columns(n);
  for (std::size_t j = 0; j + 1 < n; ++j) columns[j].push_back(static_cast<int>(j + 1));
  const auto pattern = CGP::sparse_pattern(std::move(columns));
  Matrix A(pattern);
  for (int j = 0; j < n; ++j) A.value(pattern->find(j, j)) = {2, 0, 0, 0};
  for (int j = 0; j + 1 < n; ++j) {
    const Quaternion turn = CGP::conjugate(g(j + 1, 0)) * g(j, 0);
    A.value(pattern->find(j + 1, j)) = -turn / CGP::norm(turn);
  }
  return A;
}

template <class Solver>
double residual(const Matrix& A)
{
  Solver solver;
  EXPECT_EQ(solver.analyze(A.pattern()), CGP::Solver_status::success);
  EXPECT_EQ(solver.factorize(A, {}), CGP::Solver_status::success);
  const CGP::Block<Quaternion> b = CGP::random_quaternions(n, 1, 8);
  CGP::Block<Quaternion> x;
  EXPECT_EQ(solver.solve(b, x), CGP::Solver_status::success);
  const CGP::Vector<Quaternion> r = A * x.col(0) - b.col(0);
  return std::sqrt(CGP::inner_product(r, r).w);
}

TEST(Linear_algebra, solves_a_quaternionic_system)
{
  const Matrix A = turned_path();
  EXPECT_LT(residual<CGP::Supernodal_cholesky<Quaternion>>(A), 1e-11);
}

TEST(Linear_algebra, finds_the_eigenvalues_of_a_turned_path)
{
  const Matrix A = turned_path();
  CGP::Supernodal_cholesky<Quaternion> factor;
  ASSERT_EQ(factor.analyze(A.pattern()), CGP::Solver_status::success);
  ASSERT_EQ(factor.factorize(A, {}), CGP::Solver_status::success);
  const CGP::Vector<double> masses = CGP::Vector<double>::Ones(n);
  CGP::Eigensolver_options options;
  options.wanted = 3;
  options.tolerance = 1e-10;
  const CGP::Eigensolver_result found = CGP::Lobpcg_eigensolver_traits()(
      A, masses, factor, CGP::random_quaternions(n, 4, 9), options);
  ASSERT_TRUE(found.converged);
  const double pi = std::acos(-1.);
  for (int k = 1; k <= 3; ++k)
    EXPECT_NEAR(found.values[k - 1], 2 - 2 * std::cos(k * pi / (n + 1)), 1e-12);
}

}  // namespace cgp_test::public_headers_tests
