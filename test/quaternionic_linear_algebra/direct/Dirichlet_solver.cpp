// Tests include/Quaternionic_linear_algebra/direct/Dirichlet_solver.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/direct/Dirichlet_solver.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test::dirichlet_solver_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;

constexpr int n = 30;
const std::vector<int> given = {17, 3, 4, 29, 0};

template <class Traits_and_scalar>
class Dirichlet_solver : public testing::Test {
 protected:
  using Scalar = typename Traits_and_scalar::second_type;
  using Solver = CGP::internal::Dirichlet_solver<Scalar>;
  const CGP::Spin_solvers solvers = typename Traits_and_scalar::first_type();
  using Vectors = CGP::Block<Scalar>;

  /// A x = b on the free rows, x = values on the others, by dense matrices
  void expect_solution(const Solver& solver, const CGP::Hermitian_sparse_matrix<Scalar>& A) const
  {
    const Vectors x = solver.solve(A, b, values);
    const Eigen::MatrixXd Ax = real_form(A) * real_columns(x);
    const int k = static_cast<int>(Ax.rows()) / n;  // real components
    for (int i = 0; i < n; ++i) {
      const bool is_given = solver.is_given(i);
      const Eigen::MatrixXd difference =
          is_given ? (real_columns(x) - real_columns(values)).middleRows(k * i, k).eval()
                   : (Ax - real_columns(b)).middleRows(k * i, k).eval();
      EXPECT_LE(difference.norm(), 1e-13) << i;
    }
  }

  Pattern pattern = random_pattern(n, 1);
  CGP::Hermitian_sparse_matrix<Scalar> matrix = random_definite<Scalar>(pattern, 2);
  Vectors b = random_block<Scalar>(n, 3, 3), values = random_block<Scalar>(n, 3, 4);
};

using Models = testing::Types<std::pair<CGP::Default_solver_traits, double>,
                              std::pair<CGP::Default_solver_traits, Q>,
                              std::pair<CGP::Eigen_hermitian_solver_traits, Q>>;
TYPED_TEST_SUITE(Dirichlet_solver, Models, );

TYPED_TEST(Dirichlet_solver, attaches_unknowns_by_weights)
{
  typename TestFixture::Solver solver(this->matrix.shared_pattern(), given, this->solvers);
  Eigen::VectorXd w = Eigen::VectorXd::Zero(n);
  for (const int i : given) w[i] = 1 + .5 * i;
  solver.factorize(this->matrix, w);
  const Eigen::MatrixXd x = real_columns(solver.solve(this->matrix, this->b, this->values));
  Eigen::MatrixXd left = real_form(this->matrix) * x - real_columns(this->b);
  const Eigen::MatrixXd pull = x - real_columns(this->values);
  const Eigen::Index k = left.rows() / n;
  for (Eigen::Index i = 0; i < left.rows(); ++i) left.row(i) += w[i / k] * pull.row(i);
  EXPECT_LE(left.cwiseAbs().maxCoeff(), 1e-12);
  solver.factorize(this->matrix);
  this->expect_solution(solver, this->matrix);
}

TYPED_TEST(Dirichlet_solver, solves_the_free_rows_and_keeps_the_given_ones)
{
  typename TestFixture::Solver solver(this->pattern, given, this->solvers);
  solver.factorize(this->matrix);
  this->expect_solution(solver, this->matrix);
}

TYPED_TEST(Dirichlet_solver, follows_new_values)
{
  typename TestFixture::Solver solver(this->pattern, given, this->solvers);
  for (const std::uint64_t seed : {5u, 6u}) {
    const auto A = random_definite<typename TestFixture::Scalar>(this->pattern, seed);
    solver.factorize(A);
    this->expect_solution(solver, A);
  }
}

TYPED_TEST(Dirichlet_solver, shares_the_analysis_of_another_solver)
{
  auto other = this->solvers.template solver<typename TestFixture::Scalar>();
  ASSERT_EQ(other.analyze(*this->pattern), CGP::Solver_status::success);
  typename TestFixture::Solver solver(this->pattern, given, other);
  solver.factorize(this->matrix);
  this->expect_solution(solver, this->matrix);
}

TYPED_TEST(Dirichlet_solver, knows_what_is_given)
{
  const typename TestFixture::Solver solver(this->pattern, given, this->solvers);
  for (int i = 0; i < n; ++i)
    EXPECT_EQ(solver.is_given(i), std::count(given.begin(), given.end(), i) > 0) << i;
}

TYPED_TEST(Dirichlet_solver, needs_the_matrix_to_be_definite_on_the_free_rows_only)
{
  Eigen::VectorXd s = Eigen::VectorXd::Zero(n);
  for (int i : given) s[i] = -100;
  const auto A = plus_diagonal(this->matrix, s);
  typename TestFixture::Solver solver(this->pattern, given, this->solvers);
  solver.factorize(A);
  this->expect_solution(solver, A);
}

TYPED_TEST(Dirichlet_solver, refuses_a_matrix_that_is_not_definite_there)
{
  typename TestFixture::Solver solver(this->pattern, given, this->solvers);
  const auto A = plus_diagonal(this->matrix, Eigen::VectorXd::Constant(n, -100));
  try {
    solver.factorize(A);
    FAIL() << "no exception";
  } catch (const CGP::Solver_error& error) {
    EXPECT_NE(error.message().find("factorization failed"), std::string::npos);
  }
}

TYPED_TEST(Dirichlet_solver, refuses_to_solve_before_it_has_factored)
{
  const typename TestFixture::Solver solver(this->pattern, given, this->solvers);
  EXPECT_THROW((void)solver.solve(this->matrix, this->b, this->values), CGP::Solver_error);
}

TEST(Dirichlet_solver_sharing, refuses_a_solver_that_has_none)
{
  const CGP::internal::Solver_ref<double> other;
  EXPECT_THROW(CGP::internal::Dirichlet_solver<double>(random_pattern(n, 1), given, other),
               CGP::Solver_error);
}

}  // namespace cgp_test::dirichlet_solver_tests
