// Tests krylov/Lobpcg.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>
#include <Quaternionic_linear_algebra/krylov/inverse_power_method.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "quaternionic_linear_algebra/lobpcg_runs.h"
#include "support/decompositions.h"

namespace cgp_test::lobpcg_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using Block = CGP::Block<Q>;

// A matrix, masses and a solver, with dense eigenvalues to compare.
struct Matrix_problem {
  explicit Matrix_problem(std::uint64_t seed) : A(random_definite<Q>(random_pattern(40, seed), 2))
  {
    EXPECT_EQ(solver.analyze(A.pattern()), CGP::Solver_status::success);
    EXPECT_EQ(solver.factorize(A, 1e-3 * masses), CGP::Solver_status::success);
    const Eigen::MatrixXd N = four_times(masses).asDiagonal();
    expected = symmetric_eigenvalues(real_form(A), N);
  }
  CGP::Hermitian_sparse_matrix<Q> A;
  Eigen::VectorXd masses = (random_numbers(40, 3).array() + 2).matrix();
  CGP::Eigen_hermitian_solver_traits::Solver<Q> solver;
  Eigen::VectorXd expected;  // each four times
};

/// K x = N x theta on the components of n quaternions, with eigenvalues 1, 2, ... 4n: nothing that
/// multiplication by quaternions would leave as it is.
class Real_problem {
 public:
  explicit Real_problem(int n) : m_masses(Eigen::VectorXd::Ones(4 * n))
  {
    m_masses += random_numbers(4 * n, 2) / 2;
    const Eigen::MatrixXd A = real_columns(random_block<Q>(n, 4 * n, 1));
    const Eigen::MatrixXd U = orthogonal_factor(A);
    m_vectors = m_masses.cwiseSqrt().cwiseInverse().asDiagonal() * U;
  }

  /// orthonormal in N, columns
  const Eigen::MatrixXd& vectors() const { return m_vectors; }

  auto n() const
  {
    return [this](const Block& x) { return times(m_masses.asDiagonal(), x); };
  }
  /// K + shift N to a power
  auto k(double shift = 0, int power = 1) const
  {
    const Eigen::MatrixXd duals = power > 0 ? m_masses.asDiagonal() * m_vectors : m_vectors;
    const Eigen::VectorXd values = (counting(int(m_masses.size())).array() + shift).pow(power);
    const Eigen::MatrixXd matrix = duals * values.asDiagonal() * duals.transpose();
    return [matrix](const Block& x) { return times(matrix, x); };
  }

 private:
  template <class Matrix>
  static Block times(const Matrix& A, const Block& x)
  {
    Block y(x.rows(), x.cols());
    Eigen::Map<Eigen::MatrixXd>(&y(0, 0).w, 4 * y.rows(), y.cols()) = A * real_columns(x);
    return y;
  }

  Eigen::VectorXd m_masses;
  Eigen::MatrixXd m_vectors;
};

TEST(Lobpcg, finds_simple_eigenvalues_on_a_space_over_the_reals)
{
  const Real_problem problem(10);
  CGP::Eigensolver_options options = until(1e-10, 3);
  options.coefficients = CGP::internal::Coefficients::reals;
  const auto r = CGP::lobpcg(problem.k(), problem.n(), problem.k(1e-3, -1),
                             random_block<Q>(10, 3, 3), options);
  ASSERT_TRUE(r.converged);
  for (int j = 0; j < 3; ++j) {
    EXPECT_NEAR(r.values[j], j + 1, 1e-12);
    const Eigen::VectorXd x = real_columns(r.vectors).col(j), u = problem.vectors().col(j);
    EXPECT_LE(std::min((x - u).norm(), (x + u).norm()), 1e-9);
  }
  EXPECT_LE(r.iterations, 20);
}

TEST(Lobpcg, over_the_reals_estimates_the_error_as_over_the_quaternions)
{
  const Real_problem problem(10);
  const double e = 1e-4;
  Block x0(10, 1);
  Eigen::Map<Eigen::VectorXd>(&x0(0, 0).w, 40) =
      problem.vectors().col(0) + e * problem.vectors().col(1);
  CGP::Eigensolver_options options = until(0, 1, 0);
  options.coefficients = CGP::internal::Coefficients::reals;
  const auto r = CGP::lobpcg(problem.k(), problem.n(), problem.k(0, -1), x0, options);
  EXPECT_NEAR(r.estimates[0], e * (2 - 1) / std::sqrt(2), 1e-7 * e);
}

TEST(Lobpcg, finds_the_smallest_eigenpairs_of_a_matrix)
{
  const Matrix_problem p(1);
  for (int block = 1; block <= 3; ++block) {
    const auto r = CGP::Lobpcg_eigensolver_traits{}(
        p.A, p.masses, p.solver, random_block<Q>(40, block, 4), until(1e-10, block));
    ASSERT_TRUE(r.converged);
    for (int j = 0; j < block; ++j) EXPECT_NEAR(r.values[j], p.expected[4 * j], 1e-12);
    const Eigen::MatrixXd X = real_form(r.vectors), N = four_times(p.masses).asDiagonal();
    EXPECT_LE((real_form(p.A) * X - N * X * four_times(r.values).asDiagonal()).norm(), 1e-8);
    EXPECT_LE((X.transpose() * N * X - Eigen::MatrixXd::Identity(4 * block, 4 * block)).norm(),
              1e-12);
    ASSERT_TRUE(r.gap.has_value());
    if (block > 1) {
      EXPECT_NEAR(*r.gap, p.expected[4] - p.expected[0], 1e-12);
    }
  }
}

TEST(Lobpcg, takes_a_mass_matrix_as_well)
{
  const Matrix_problem p(5);
  const auto N = random_definite<Q>(p.A.shared_pattern(), 6);
  const auto r =
      CGP::Lobpcg_eigensolver_traits{}(p.A, N, p.solver, random_block<Q>(40, 1, 7), until(1e-10));
  ASSERT_TRUE(r.converged);
  EXPECT_NEAR(r.values[0], symmetric_eigenvalues(real_form(p.A), real_form(N))[0], 1e-12);
}

TEST(Lobpcg, finds_eigenvalues_of_the_matrix_that_the_iterates_have_led_to)
{
  for (int block = 1; block <= 2; ++block) {
    Matrix_problem p(1);
    const double start = p.A.value(0).w;  // A_00, which becomes start + 300 |x_0|^2
    CGP::Eigensolver_options options = until(1e-10, block);
    options.adapt = [&](const CGP::Eigensolver_progress& progress) {
      p.A.value(0).w = start + 300 * CGP::squared_norm((*progress.vectors)(0, 0));
      return true;
    };
    const auto r = CGP::Lobpcg_eigensolver_traits{}(p.A, p.masses, p.solver,
                                                    random_block<Q>(40, block, 4), options);
    ASSERT_TRUE(r.converged);
    const Eigen::MatrixXd N = four_times(p.masses).asDiagonal();
    const Eigen::VectorXd expected = symmetric_eigenvalues(real_form(p.A), N);
    for (int j = 0; j < block; ++j) EXPECT_NEAR(r.values[j], expected[4 * j], 1e-12);
    EXPECT_GT(r.values[0], p.expected[0] + 1e-3);
    EXPECT_NEAR(p.A.value(0).w, start + 300 * CGP::squared_norm(r.vectors(0, 0)), 1e-8);
  }
}

TEST(Lobpcg, estimates_the_error_in_the_energy_norm)
{
  // x = u_1 + e u_2 has r = e (theta_2 - theta_1) N u_2 and T r = r / theta_2, to first order.
  const Spectral_problem problem(counting(10));
  const double e = 1e-4;
  Block x0 = problem.vectors().leftCols(1);
  for (int i = 0; i < 10; ++i) x0(i, 0) += e * problem.vectors()(i, 1);
  CGP::Eigensolver_options options = until(0, 1, 0);
  options.scale = 3;
  const auto r = solve(problem, x0, options, 0);
  EXPECT_NEAR(r.estimates[0], e * (2 - 1) / std::sqrt(2) / 3, 1e-7 * e);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.iterations, 0);
}

TEST(Lobpcg, stops_when_the_vector_is_as_exact_as_asked)
{
  const Spectral_problem problem(counting(30));
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
    const auto r = solve(problem, random_block<Q>(30, 1, 2), until(tolerance));
    EXPECT_TRUE(r.converged);
    EXPECT_LE(r.estimates[0], tolerance);
    // e (theta_2 - theta_1) / sqrt(theta_2) is at least e / sqrt(2) here.
    EXPECT_LE(problem.sine(r.vectors), 1.5 * tolerance);
  }
}

TEST(Lobpcg, converges_with_a_crude_preconditioner)
{
  const Spectral_problem problem(counting(60));
  const auto nothing = [](const Block& r) { return r; };
  const auto r =
      CGP::lobpcg(problem.k(), problem.n(), nothing, random_block<Q>(60, 2, 7), until(1e-8));
  EXPECT_TRUE(r.converged);
  EXPECT_LE(problem.sine(r.vectors.leftCols(1)), 1e-7);
  EXPECT_GT(r.iterations, 10);
}

TEST(Lobpcg, needs_fewer_iterations_than_the_inverse_power_method)
{
  Eigen::VectorXd values = 2 * counting(40);
  values[0] = 1;
  values[1] = 1 / 0.83;
  const Spectral_problem problem(values);
  const Block x0 = random_block<Q>(40, 1, 8);
  const auto fast = solve(problem, x0, until(1e-8));
  const auto slow =
      CGP::inverse_power_method(problem.k(), problem.n(), problem.inverse(), x0, until(1e-8));
  ASSERT_TRUE(fast.converged && slow.converged);
  EXPECT_LT(3 * fast.iterations, slow.iterations);
}

TEST(Lobpcg, bounds_the_gap_with_one_column)
{
  const Spectral_problem problem(counting(30));
  const auto r = solve(problem, random_block<Q>(30, 1, 2), until(1e-7));
  ASSERT_TRUE(r.gap.has_value());
  EXPECT_GE(*r.gap, 1 - 1e-12);  // by the law of Courant and Fischer
  EXPECT_LE(*r.gap, 2);
  const auto at_once = solve(problem, problem.vectors().leftCols(1), until(1e-7));
  EXPECT_FALSE(at_once.gap.has_value());
}

TEST(Lobpcg, turns_its_answer_with_the_initial_vector)
{
  const Spectral_problem problem(counting(20));
  const Q q = Q{1, 2, -2, 4} / 5;
  const Block x0 = random_block<Q>(20, 1, 9), gauge = Block::Constant(1, 1, q);
  const auto a = solve(problem, x0, until(1e-8));
  const auto b = solve(problem, CGP::combination(x0, gauge), until(1e-8));
  EXPECT_LE((real_columns(CGP::combination(a.vectors, gauge)) - real_columns(b.vectors)).norm(),
            1e-12);
}

TEST(Lobpcg, gives_the_same_bits_again)
{
  const Spectral_problem problem(counting(20));
  const auto a = solve(problem, random_block<Q>(20, 2, 10), until(1e-8));
  const auto b = solve(problem, random_block<Q>(20, 2, 10), until(1e-8));
  EXPECT_EQ(real_columns(a.vectors), real_columns(b.vectors));
}

TEST(Lobpcg, can_be_cancelled)
{
  const Spectral_problem problem(counting(30));
  std::vector<int> seen;
  double value = 0;
  const auto r = solve(problem, random_block<Q>(30, 1, 11), until(0), 1e-3,
                       [&](const CGP::Eigensolver_progress& progress) {
                         seen.push_back(progress.iteration);
                         value = progress.value;
                         EXPECT_GT(progress.estimate, 0);
                         return progress.iteration < 2;
                       });
  EXPECT_TRUE(r.cancelled);
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(seen, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(r.iterations, 2);
  EXPECT_EQ(r.values[0], value);
}

TEST(Lobpcg, gives_up_after_the_maximal_number_of_iterations)
{
  const Spectral_problem problem(counting(30));
  const auto r = solve(problem, random_block<Q>(30, 1, 12), until(1e-14, 1, 3));
  EXPECT_FALSE(r.converged);
  EXPECT_FALSE(r.stagnated);
  EXPECT_EQ(r.iterations, 3);
  EXPECT_EQ(r.solves, 4);
  EXPECT_GT(r.estimates[0], 1e-14);
}

TEST(Lobpcg, refuses_initial_vectors_that_cannot_do)
{
  const Spectral_problem problem(counting(10));
  EXPECT_THROW(solve(problem, Block(10, 0), until(1e-6)), CGP::Precondition_error);
  EXPECT_THROW(solve(problem, random_block<Q>(10, 1, 1), until(1e-6, 2)), CGP::Precondition_error);
  EXPECT_THROW(solve(problem, random_block<Q>(10, 1, 1), until(1e-6, 0)), CGP::Precondition_error);
  EXPECT_THROW(solve(problem, Block(10, 1), until(1e-6)), CGP::Precondition_error);
  Block same = random_block<Q>(10, 2, 1);
  same.col(1) = same.col(0);
  EXPECT_THROW(solve(problem, same, until(1e-6)), CGP::Precondition_error);
}

TEST(Lobpcg, refuses_operators_that_return_values_that_are_not_finite)
{
  const Spectral_problem problem(counting(10));
  const auto broken = [](Block r) {
    r(3, 0).x = std::numeric_limits<double>::quiet_NaN();
    return r;
  };
  EXPECT_THROW(
      CGP::lobpcg(problem.k(), problem.n(), broken, random_block<Q>(10, 1, 1), until(1e-6)),
      CGP::Solver_error);
}

}  // namespace cgp_test::lobpcg_tests
