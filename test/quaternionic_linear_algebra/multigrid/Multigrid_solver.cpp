// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/multigrid/Multigrid_solver.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/multigrid_tools.h"
#include "quaternionic_linear_algebra/solver_laws.h"
#include "support/spheres.h"

#include <limits>

namespace cgp_test::multigrid_solver_tests {

template <class Scalar>
class Rounding_remainder : public testing::Test {
 protected:
  Pattern pattern = random_pattern(50, 1);
  CGP::Hermitian_sparse_matrix<Scalar> A = random_hermitian<Scalar>(pattern, 2);
  CGP::internal::Rounding_remainder<Scalar> remainder;
};
using Scalars = testing::Types<double, Quaternion<double>>;
TYPED_TEST_SUITE(Rounding_remainder, Scalars);

TYPED_TEST(Rounding_remainder, completes_the_rounded_matrix_to_fourteen_digits)
{
  const auto rounded = this->remainder.split(this->A, {});
  const auto x = random_block<TypeParam>(50, 3, 3);
  CGP::Block<TypeParam> y;
  this->remainder.multiply(rounded, x, y);
  const Eigen::MatrixXd expected = real_form(this->A) * real_columns(x);
  EXPECT_LT(relative_difference(real_columns(y), expected), 2e-15);
}

TYPED_TEST(Rounding_remainder, belongs_to_a_matrix_rounded_to_single_precision)
{
  const auto rounded = this->remainder.split(this->A, {});
  EXPECT_EQ(rounded.shared_pattern(), this->A.shared_pattern());
  EXPECT_TRUE(this->remainder.is_finite());
  for (int k = 0; k < this->pattern->size_of_entries(); ++k)
    EXPECT_EQ(rounded.value(k), CGP::internal::to_single(this->A.value(k)));
}

TYPED_TEST(Rounding_remainder, includes_a_shift_of_the_diagonal)
{
  const Eigen::VectorXd shift = random_numbers(50, 4);
  const auto rounded = this->remainder.split(this->A, shift);
  const auto x = random_block<TypeParam>(50, 1, 5);
  CGP::Block<TypeParam> y;
  this->remainder.multiply(rounded, x, y);
  const Eigen::MatrixXd expected = real_form(plus_diagonal(this->A, shift)) * real_columns(x);
  EXPECT_LT(relative_difference(real_columns(y), expected), 2e-15);
}

TYPED_TEST(Rounding_remainder, tells_values_that_are_not_finite_in_single_precision)
{
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e39, -1e39}) {
    auto B = this->A;
    B.value(7) = CGP::internal::Scalar_traits<TypeParam>::from_real(bad);
    this->remainder.split(B, {});
    EXPECT_FALSE(this->remainder.is_finite());
  }
  this->remainder.split(this->A, {});
  EXPECT_TRUE(this->remainder.is_finite());
}

TYPED_TEST(Rounding_remainder, takes_as_much_memory_as_the_rounded_matrix)
{
  this->remainder.split(this->A, {});
  EXPECT_EQ(this->remainder.bytes(), 4. * planes_of<TypeParam> * this->pattern->size_of_entries());
  this->remainder.release();
  EXPECT_EQ(this->remainder.bytes(), 0);
}

using Models = testing::Types<CGP::internal::Multigrid_solver<double>,
                              CGP::internal::Multigrid_solver<Quaternion<double>>>;
INSTANTIATE_TYPED_TEST_SUITE_P(Multigrid, Hermitian_solver, Models);

static_assert(std::is_same_v<CGP::Multigrid_solver_traits::Solver<double>,
                             CGP::internal::Multigrid_solver<double>>);

/// The nearly singular matrices of a spin transformation of a sphere
CGP::Hermitian_sparse_matrix<double> sphere_matrix(const Mesh_view& mesh, double)
{
  return plus_diagonal(CGP::cotan_laplacian(mesh), 1e-3 * CGP::vertex_areas(mesh));
}
CGP::Hermitian_sparse_matrix<Quaternion<double>> sphere_matrix(const Mesh_view& mesh,
                                                               const Quaternion<double>&)
{
  const auto rho = rho_of_section_3_on_vertices(mesh);
  return plus_diagonal(CGP::dirac_energy(mesh, CGP::Curvature_potential::on_vertices(rho)),
                       1e-3 * CGP::vertex_areas(mesh));
}

template <class Solver_>
class Multigrid_solver : public testing::Test {
 protected:
  using Scalar = typename Solver_::Scalar;
  static constexpr int n = 30 * 31;

  void prepare(const CGP::Hermitian_sparse_matrix<Scalar>& matrix)
  {
    ASSERT_EQ(solver.analyze(matrix.pattern()), Solver_status::success);
    ASSERT_EQ(solver.factorize(matrix, {}), Solver_status::success);
  }

  CGP::Block<Scalar> solution(const CGP::Block<Scalar>& b)
  {
    CGP::Block<Scalar> x;
    EXPECT_EQ(solver.solve(b, x), Solver_status::success);
    return x;
  }

  CGP::Block<Scalar> preconditioned(const CGP::Block<Scalar>& b)
  {
    CGP::Block<Scalar> x;
    EXPECT_EQ(solver.precondition(b, x), Solver_status::success);
    return x;
  }

  Pattern pattern = grid_pattern(30, 31);
  CGP::Hermitian_sparse_matrix<Scalar> A = random_definite<Scalar>(pattern, 2);
  Solver_ solver;
};
TYPED_TEST_SUITE(Multigrid_solver, Models);

TYPED_TEST(Multigrid_solver, finds_the_solution_of_the_direct_solver)
{
  using Number = typename TypeParam::Scalar;
  const auto K = sphere_matrix(geodesic_sphere(16), Number{});
  this->prepare(K);
  CGP::Supernodal_cholesky<Number> direct;
  ASSERT_EQ(direct.analyze(K.pattern()), Solver_status::success);
  ASSERT_EQ(direct.factorize(K, {}), Solver_status::success);
  const auto b = random_block<Number>(K.size(), 5, 3);
  CGP::Block<Number> expected;
  ASSERT_EQ(direct.solve(b, expected), Solver_status::success);
  EXPECT_LT(relative_difference(real_columns(this->solution(b)), real_columns(expected)), 1e-9);
}

TYPED_TEST(Multigrid_solver, needs_no_more_iterations_for_finer_meshes)
{
  using Number = typename TypeParam::Scalar;
  for (const int frequency : {8, 24}) {
    const auto K = sphere_matrix(geodesic_sphere(frequency), Number{});
    this->prepare(K);
    this->solution(random_block<Number>(K.size(), 1, 4));
    EXPECT_GT(this->solver.iterations(), 3);
    EXPECT_LE(this->solver.iterations(), 25);
  }
}

TYPED_TEST(Multigrid_solver, solves_with_a_shift_after_the_matrix_is_gone)
{
  const Eigen::VectorXd shift = random_numbers(this->n, 5).cwiseAbs();
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  {
    const auto copy = std::make_unique<CGP::Hermitian_sparse_matrix<typename TypeParam::Scalar>>(
        plus_diagonal(this->A, -shift));
    ASSERT_EQ(this->solver.factorize(*copy, 2 * shift), Solver_status::success);
  }
  const auto x = random_block<typename TypeParam::Scalar>(this->n, 1, 6);
  const CGP::Block<typename TypeParam::Scalar> b = plus_diagonal(this->A, shift) * x.col(0);
  EXPECT_LT(relative_difference(real_columns(this->solution(b)), real_columns(x)), 1e-9);
}

TYPED_TEST(Multigrid_solver, solves_where_a_row_is_that_of_the_identity)
{
  using Number = typename TypeParam::Scalar;
  auto K = sphere_matrix(geodesic_sphere(10), Number{});
  for (int k = 0; k < K.pattern().offsets[1]; ++k)
    K.value(k) = CGP::internal::Scalar_traits<Number>::from_real(k == 0);
  this->prepare(K);
  const auto x = random_block<Number>(K.size(), 1, 7);
  const CGP::Block<Number> b = K * x.col(0);
  EXPECT_LT(relative_difference(real_columns(this->solution(b)), real_columns(x)), 1e-9);
}

TYPED_TEST(Multigrid_solver, preconditions_by_a_fixed_positive_operator_column_by_column)
{
  this->prepare(this->A);
  const auto a = random_block<typename TypeParam::Scalar>(this->n, 6, 8);
  const auto Ta = this->preconditioned(a);
  const Eigen::MatrixXd u = real_columns(a), Tu = real_columns(Ta);
  const Eigen::MatrixXd G = u.transpose() * Tu;
  EXPECT_LT(relative_difference(G, G.transpose()), 1e-5);
  EXPECT_GT(G.diagonal().minCoeff(), 0);
  for (const int c : {0, 3, 5})
    EXPECT_LT(relative_difference(real_columns(this->preconditioned(a.col(c))), Tu.col(c)), 1e-6);
  auto in_place = a;
  ASSERT_EQ(this->solver.precondition(in_place, in_place), Solver_status::success);
  EXPECT_EQ(real_columns(in_place), Tu);
}

TYPED_TEST(Multigrid_solver, gives_the_same_bits_twice)
{
  this->prepare(this->A);
  const auto b = random_block<typename TypeParam::Scalar>(this->n, 3, 9);
  const auto x = this->solution(b);
  this->prepare(this->A);
  EXPECT_EQ(real_columns(this->solution(b)), real_columns(x));
}

TYPED_TEST(Multigrid_solver, is_prepared_like_another_one)
{
  ASSERT_EQ(this->solver.analyze_with_positions(*this->pattern, Eigen::Matrix3Xd::Zero(3, this->n)),
            Solver_status::success);
  CGP::internal::Multigrid_solver<double> other;
  ASSERT_EQ(other.analyze_like(*this->pattern, this->solver), Solver_status::success);
  EXPECT_EQ(other.ordering(), this->solver.ordering());
  EXPECT_EQ(other.factorize(random_definite<double>(this->pattern, 10), {}),
            Solver_status::success);
}

TYPED_TEST(Multigrid_solver, keeps_a_given_ordering)
{
  const CGP::internal::Ordering order = random_permutation(this->n, 11);
  ASSERT_EQ(this->solver.analyze(*this->pattern, order), Solver_status::success);
  EXPECT_EQ(this->solver.ordering(), order);
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  EXPECT_EQ(this->solver.ordering()[7], 7);
  EXPECT_EQ(this->solver.analyze(*this->pattern, {0, 1}), Solver_status::wrong_state);
}

TYPED_TEST(Multigrid_solver, reports_matrices_that_are_not_definite)
{
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(this->n);
  shift[400] = -2 * this->A.diagonal(400);
  EXPECT_EQ(this->solver.factorize(this->A, shift), Solver_status::not_positive_definite);
  const auto b = random_block<typename TypeParam::Scalar>(this->n, 1, 12);
  CGP::Block<typename TypeParam::Scalar> x;
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
  EXPECT_EQ(this->solver.precondition(b, x), Solver_status::wrong_state);
  ASSERT_EQ(this->solver.factorize(this->A, {}), Solver_status::success);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::success);
}

TYPED_TEST(Multigrid_solver, reports_when_iteration_shows_that_the_matrix_is_not_definite)
{
  // Positive entries connect nothing; the eigenvalues of this path begin at -0.1.
  CGP::Hermitian_sparse_matrix<typename TypeParam::Scalar> B(grid_pattern(1, 600));
  for (int k = 0; k < B.pattern().size_of_entries(); ++k)
    B.value(k) = CGP::internal::Scalar_traits<typename TypeParam::Scalar>::from_real(1);
  this->prepare(plus_diagonal(B, Eigen::VectorXd::Constant(600, 0.9)));
  CGP::Block<typename TypeParam::Scalar> x;
  EXPECT_EQ(this->solver.solve(random_block<typename TypeParam::Scalar>(600, 1, 13), x),
            Solver_status::not_positive_definite);
  EXPECT_EQ(x.size(), 0);
}

TYPED_TEST(Multigrid_solver, reports_when_iteration_takes_too_long)
{
  // Positive entries connect nothing, and Gauss-Seidel alone is slow on a long path.
  CGP::Hermitian_sparse_matrix<typename TypeParam::Scalar> B(grid_pattern(1, 2500));
  for (int k = 0; k < B.pattern().size_of_entries(); ++k)
    B.value(k) = CGP::internal::Scalar_traits<typename TypeParam::Scalar>::from_real(1);
  this->prepare(plus_diagonal(B, Eigen::VectorXd::Constant(2500, 1 + 1e-9)));
  CGP::Block<typename TypeParam::Scalar> x;
  EXPECT_EQ(this->solver.solve(random_block<typename TypeParam::Scalar>(2500, 1, 14), x),
            Solver_status::numerical_issue);
  EXPECT_EQ(x.size(), 0);
}

TYPED_TEST(Multigrid_solver, reports_values_that_are_not_finite)
{
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  auto B = this->A;
  B.value(100) = CGP::internal::Scalar_traits<typename TypeParam::Scalar>::from_real(
      std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(this->solver.factorize(B, {}), Solver_status::numerical_issue);
  ASSERT_EQ(this->solver.factorize(this->A, {}), Solver_status::success);
  CGP::Block<typename TypeParam::Scalar> b(this->n, 1), x;
  b.setConstant(B.value(100));
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::numerical_issue);
}

TYPED_TEST(Multigrid_solver, tells_the_cost_and_gives_memory_back)
{
  const int entries = this->pattern->size_of_entries();
  EXPECT_EQ(this->solver.statistics().factor_entries, 0);
  ASSERT_EQ(this->solver.analyze(*this->pattern), Solver_status::success);
  EXPECT_EQ(this->solver.statistics().factor_entries, entries);
  ASSERT_EQ(this->solver.factorize(this->A, {}), Solver_status::success);
  EXPECT_GT(this->solver.statistics().factor_entries, entries);
  EXPECT_GT(this->solver.statistics().bytes, 8. * planes_of<typename TypeParam::Scalar> * entries);
  this->solver.release();
  EXPECT_EQ(this->solver.statistics().factor_entries, entries);
  const auto b = random_block<typename TypeParam::Scalar>(this->n, 1, 15);
  CGP::Block<typename TypeParam::Scalar> x;
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::wrong_state);
  ASSERT_EQ(this->solver.factorize(this->A, {}), Solver_status::success);
  EXPECT_EQ(this->solver.solve(b, x), Solver_status::success);
}

}  // namespace cgp_test::multigrid_solver_tests
