// Tests include/Quaternionic_linear_algebra/multigrid/Multigrid_cycle.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Quaternionic_linear_algebra/multigrid/Multigrid_cycle.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <limits>

#include "quaternionic_linear_algebra/multigrid_tools.h"
#include "support/decompositions.h"

namespace cgp_test::multigrid_cycle_tests {

using CGP::Solver_status;

/// a hierarchy of several levels although the matrix is small
CGP::internal::Multigrid_options options_for(int coarsest_size)
{
  CGP::internal::Multigrid_options options;
  options.coarsest_size = coarsest_size;
  return options;
}

template <class Scalar>
class Multigrid_cycle : public testing::Test {
 protected:
  static constexpr int columns = columns_of<Scalar>;

  Solver_status build(const CGP::Hermitian_sparse_matrix<Scalar>& A,
                      const CGP::internal::Multigrid_options& options = {})
  {
    return cycle.build(single(A), options);
  }

  Solver_status apply(const Eigen::MatrixXd& b, Eigen::MatrixXd& x)
  {
    x.resize(b.rows(), b.cols());
    Eigen::MatrixXd c = b;
    return cycle.apply(
        [&](int i, double* to) {
          for (int q = 0; q < 4; ++q) to[q] = lane<Scalar>(c, i, q);
        },
        [&](int i, const double* from) {
          for (int q = 0; q < 4; ++q) lane<Scalar>(x, i, q) = from[q];
        });
  }

  Eigen::MatrixXd applied(const Eigen::MatrixXd& b)
  {
    Eigen::MatrixXd x;
    EXPECT_EQ(apply(b, x), Solver_status::success);
    return x;
  }

  // The cycle as a matrix, in real form.
  Eigen::MatrixXd matrix(int rows)
  {
    const int size = rows * planes_of<Scalar>;
    Eigen::MatrixXd T(size, size);
    for (int j = 0; j < size; ++j) {
      const Eigen::VectorXd unit = Eigen::VectorXd::Unit(size, j);
      T.col(j) = applied(unit.replicate(1, columns)).col(0);
    }
    return T;
  }

  CGP::internal::Multigrid_cycle<Entry_of<Scalar>> cycle;
};
using Scalars = testing::Types<double, Quaternion<double>>;
TYPED_TEST_SUITE(Multigrid_cycle, Scalars);

template <class Scalar>
CGP::Hermitian_sparse_matrix<Scalar> laplacian(const Pattern& pattern, std::uint64_t seed)
{
  const auto L = random_laplacian(pattern, seed);
  CGP::Hermitian_sparse_matrix<Scalar> A(pattern);
  for (int k = 0; k < pattern->size_of_entries(); ++k)
    A.value(k) = CGP::internal::Scalar_traits<Scalar>::from_real(L.value(k));
  return A;
}

TYPED_TEST(Multigrid_cycle, is_hermitian_and_positive_definite)
{
  const Pattern pattern = grid_pattern(9, 10);
  const Eigen::VectorXd shift = Eigen::VectorXd::Constant(pattern->size(), 0.01);
  for (const auto& A : {random_definite<TypeParam>(random_pattern(80, 1), 2),
                        plus_diagonal(laplacian<TypeParam>(pattern, 3), shift)}) {
    ASSERT_EQ(this->build(A, options_for(20)), Solver_status::success);
    const Eigen::MatrixXd T = this->matrix(A.size());
    EXPECT_LT(relative_difference(T, T.transpose()), 2e-6);
    const Eigen::VectorXd eigenvalues = symmetric_eigenvalues(T);
    EXPECT_GT(eigenvalues.minCoeff(), 1e-3 / real_form(A).norm());
  }
}

TYPED_TEST(Multigrid_cycle, is_close_to_the_inverse)
{
  const Pattern pattern = grid_pattern(11, 11);
  const Eigen::VectorXd shift = Eigen::VectorXd::Constant(pattern->size(), 0.01);
  const auto A = plus_diagonal(laplacian<TypeParam>(pattern, 3), shift);
  for (const int coarsest_size : {10, 1000}) {
    ASSERT_EQ(this->build(A, options_for(coarsest_size)), Solver_status::success);
    const Eigen::MatrixXd L = cholesky_factor(real_form(A));
    const Eigen::MatrixXd TA = L.transpose() * this->matrix(A.size()) * L;
    const Eigen::VectorXd eigenvalues = symmetric_eigenvalues(TA);
    EXPECT_GT(eigenvalues.minCoeff(), 0.15);
    EXPECT_LT(eigenvalues.maxCoeff(), 1.0001);
  }
}

TYPED_TEST(Multigrid_cycle, has_levels_down_to_the_size_that_is_asked_for)
{
  const auto A = random_definite<TypeParam>(grid_pattern(40, 40), 4);
  ASSERT_EQ(this->build(A, options_for(100)), Solver_status::success);
  EXPECT_GE(this->cycle.levels().size(), 2u);
  EXPECT_GT(this->cycle.levels().back().size(), 100);
  EXPECT_LE(this->cycle.coarsest_size(), 100);
  ASSERT_EQ(this->build(A, options_for(100000)), Solver_status::success);
  EXPECT_EQ(this->cycle.levels().size(), 1u);
}

TYPED_TEST(Multigrid_cycle, is_the_inverse_where_there_are_no_connections)
{
  const auto A = random_definite<TypeParam>(pattern_of_edges(30, {}), 5);
  ASSERT_EQ(this->build(A), Solver_status::success);
  EXPECT_EQ(this->cycle.coarsest_size(), 0);
  const Eigen::MatrixXd x = real_columns(random_block<TypeParam>(30, this->columns, 6));
  EXPECT_LT(relative_difference(this->applied(real_form(A) * x), x), 1e-6);
}

TYPED_TEST(Multigrid_cycle, solves_for_vertices_that_are_cut_off_exactly)
{
  auto A = random_definite<TypeParam>(grid_pattern(12, 12), 7);
  for (int k = A.pattern().offsets[0] + 1; k < A.pattern().offsets[1]; ++k) A.value(k) = {};
  ASSERT_EQ(this->build(A, options_for(10)), Solver_status::success);
  const Eigen::MatrixXd T = this->matrix(144);
  EXPECT_NEAR(T(0, 0) * A.diagonal(0), 1, 1e-6);
  EXPECT_LT((T.row(0).tail(140)).norm(), 1e-12);
}

TYPED_TEST(Multigrid_cycle, is_linear_for_right_hand_sides_of_any_size)
{
  const auto A = random_definite<TypeParam>(grid_pattern(12, 12), 8);
  ASSERT_EQ(this->build(A), Solver_status::success);
  const Eigen::MatrixXd b = real_columns(random_block<TypeParam>(144, this->columns, 9));
  const Eigen::MatrixXd x = this->applied(b);
  for (const double scale : {std::ldexp(1., 500), std::ldexp(1., -500)})
    EXPECT_EQ(this->applied(scale * b), scale * x);
  EXPECT_EQ(this->applied(0 * b), 0 * b);
}

TYPED_TEST(Multigrid_cycle, gives_the_same_bits_twice)
{
  const auto A = random_definite<TypeParam>(random_pattern(400, 12), 13);
  const Eigen::MatrixXd b = real_columns(random_block<TypeParam>(400, this->columns, 14));
  ASSERT_EQ(this->build(A, options_for(30)), Solver_status::success);
  const Eigen::MatrixXd x = this->applied(b);
  ASSERT_EQ(this->build(A, options_for(30)), Solver_status::success);
  EXPECT_EQ(this->applied(b), x);
}

TYPED_TEST(Multigrid_cycle, refuses_matrices_that_are_seen_not_to_be_definite)
{
  auto A = random_definite<TypeParam>(grid_pattern(10, 10), 15);
  A.value(A.pattern().offsets[50]) = CGP::internal::Scalar_traits<TypeParam>::from_real(-1);
  EXPECT_EQ(this->build(A), Solver_status::not_positive_definite);
  // Positive on the diagonal, negative for vectors that vary slowly.
  const Eigen::VectorXd shift = Eigen::VectorXd::Constant(100, -0.5);
  A = plus_diagonal(laplacian<TypeParam>(grid_pattern(10, 10), 16), shift);
  EXPECT_EQ(this->build(A), Solver_status::not_positive_definite);
}

TYPED_TEST(Multigrid_cycle, survives_the_rounding_of_matrices_that_are_nearly_singular)
{
  const auto A = laplacian<TypeParam>(grid_pattern(30, 30), 17);
  ASSERT_EQ(this->build(A), Solver_status::success);
  Eigen::MatrixXd b = real_columns(random_block<TypeParam>(900, this->columns, 18));
  const Eigen::MatrixXd x = this->applied(b);
  EXPECT_TRUE(x.allFinite());
  EXPECT_GT(x.cwiseProduct(b).sum(), 0);
}

TYPED_TEST(Multigrid_cycle, reports_right_hand_sides_that_are_not_finite)
{
  ASSERT_EQ(this->build(random_definite<TypeParam>(grid_pattern(5, 5), 19)),
            Solver_status::success);
  Eigen::MatrixXd b = real_columns(random_block<TypeParam>(25, this->columns, 20)), x;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    b(7, 0) = bad;
    EXPECT_EQ(this->apply(b, x), Solver_status::numerical_issue);
  }
}

TYPED_TEST(Multigrid_cycle, tells_its_cost_and_gives_the_memory_back)
{
  const auto A = random_definite<TypeParam>(grid_pattern(30, 30), 21);
  ASSERT_EQ(this->build(A, options_for(50)), Solver_status::success);
  const CGP::Solver_statistics s = this->cycle.statistics();
  EXPECT_GT(s.factor_entries, A.pattern().size_of_entries());
  EXPECT_LT(s.factor_entries, 2 * A.pattern().size_of_entries());
  EXPECT_GT(s.flops, static_cast<double>(s.factor_entries));
  EXPECT_GT(s.bytes, 4 * planes_of<TypeParam> * static_cast<double>(s.factor_entries));
  this->cycle.release();
  EXPECT_EQ(this->cycle.statistics().bytes, 0);
  EXPECT_TRUE(this->cycle.levels().empty());
}

}  // namespace cgp_test::multigrid_cycle_tests
