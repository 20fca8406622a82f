// Tests include/Conformal_geometry_processing/spin/Exactness_constraints.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/random.h"

namespace cgp_test::weighted_orthonormalization_tests {

namespace CGP = Conformal_geometry_processing;

Eigen::VectorXd some_weights(int n)
{
  return random_numbers(n, 1).array() + 1.5;
}

Eigen::MatrixXd some_functions(int n, int k)
{
  Eigen::MatrixXd F(n, k);
  for (int j = 0; j < k; ++j) F.col(j) = random_numbers(n, 10 + static_cast<unsigned>(j));
  return F;
}

Eigen::MatrixXd gram(const Eigen::MatrixXd& F, const Eigen::VectorXd& weights)
{
  Eigen::MatrixXd G(F.cols(), F.cols());
  for (Eigen::Index i = 0; i < F.cols(); ++i)
    for (Eigen::Index j = 0; j < F.cols(); ++j)
      G(i, j) = (weights.array() * F.col(i).array() * F.col(j).array()).sum();
  return G;
}

double orthonormality_defect(const Eigen::MatrixXd& F, const Eigen::VectorXd& weights)
{
  return (gram(F, weights) - Eigen::MatrixXd::Identity(F.cols(), F.cols())).cwiseAbs().maxCoeff();
}

std::string message(const Eigen::MatrixXd& functions, const Eigen::VectorXd& weights)
{
  try {
    CGP::weighted_orthonormalization(functions, weights);
  } catch (const CGP::Precondition_error& e) {
    return e.message();
  }
  return "";
}

TEST(Weighted_orthonormalization, divides_one_function_by_its_weighted_norm)
{
  const Eigen::Vector2d f(3, 4), weights(1, 4);  // 9 + 64
  const Eigen::MatrixXd basis = CGP::weighted_orthonormalization(f, weights);
  ASSERT_EQ(basis.cols(), 1);
  EXPECT_NEAR((basis.cwiseAbs() - f / std::sqrt(73.)).norm(), 0, 1e-15);
}

TEST(Weighted_orthonormalization, spans_the_same_functions_orthonormally)
{
  const Eigen::VectorXd weights = some_weights(40);
  const Eigen::MatrixXd F = some_functions(40, 5);
  const Eigen::MatrixXd basis = CGP::weighted_orthonormalization(F, weights);
  ASSERT_EQ(basis.cols(), 5);
  EXPECT_LT(orthonormality_defect(basis, weights), 1e-14);
  for (int j = 0; j < 5; ++j)
    EXPECT_LT(CGP::project_out(basis, weights, F.col(j)).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Weighted_orthonormalization, is_orthonormal_to_rounding_also_near_the_threshold)
{
  const Eigen::VectorXd weights = some_weights(60);
  Eigen::MatrixXd F = some_functions(60, 4);
  F.col(2) = F.col(0) + 1e-2 * F.col(2);
  F.col(3) = F.col(1) + 5e-3 * F.col(3);
  const Eigen::MatrixXd basis = CGP::weighted_orthonormalization(F, weights);
  ASSERT_EQ(basis.cols(), 4);
  EXPECT_LT(orthonormality_defect(basis, weights), 1e-14);
}

TEST(Weighted_orthonormalization, drops_just_what_lies_below_the_threshold)
{
  const Eigen::VectorXd weights = some_weights(60);
  const Eigen::MatrixXd E = CGP::weighted_orthonormalization(some_functions(60, 3), weights);
  for (const double small : {1.1e-3, .9e-3, 1e-12, 0.}) {
    Eigen::MatrixXd F = E;  // singular values 1, 1, small, in directions that are not the columns'
    F.col(2) *= small;
    F.col(0) += F.col(2);
    const int rank = small > 1e-3 ? 3 : 2;
    EXPECT_EQ(CGP::weighted_orthonormalization(F, weights).cols(), rank);
    EXPECT_EQ(CGP::weighted_orthonormalization(F, weights, .5).cols(), 2);
  }
}

TEST(Weighted_orthonormalization, keeps_of_dependent_functions_the_span_and_not_the_noise)
{
  const Eigen::VectorXd weights = some_weights(60);
  Eigen::MatrixXd F = some_functions(60, 4);
  const Eigen::VectorXd noise = F.col(3);
  F.col(3) = F.col(0) - 2 * F.col(1) + 1e-5 * noise;
  const Eigen::MatrixXd basis = CGP::weighted_orthonormalization(F, weights);
  ASSERT_EQ(basis.cols(), 3);
  EXPECT_LT(CGP::project_out(basis, weights, F.col(0)).norm(), 1e-4);
  EXPECT_GT(CGP::project_out(basis, weights, noise).norm(), .5 * noise.norm());
}

TEST(Weighted_orthonormalization, does_not_depend_on_the_scale)
{
  const Eigen::VectorXd weights = some_weights(30);
  const Eigen::MatrixXd F = some_functions(30, 3);
  const Eigen::MatrixXd basis = CGP::weighted_orthonormalization(F, weights);
  const Eigen::MatrixXd other = CGP::weighted_orthonormalization(1e-20 * F, weights);
  EXPECT_LT((basis - other).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Weighted_orthonormalization, of_nothing_is_empty)
{
  const Eigen::VectorXd weights = some_weights(7);
  EXPECT_EQ(CGP::weighted_orthonormalization(Eigen::MatrixXd(7, 0), weights).cols(), 0);
  const Eigen::MatrixXd basis =
      CGP::weighted_orthonormalization(Eigen::MatrixXd::Zero(7, 3), weights);
  EXPECT_EQ(basis.rows(), 7);
  EXPECT_EQ(basis.cols(), 0);
  EXPECT_EQ(CGP::project_out(basis, weights, weights), weights);
}

TEST(Weighted_orthonormalization, gives_the_same_bits_again)
{
  const Eigen::VectorXd weights = some_weights(500);
  const Eigen::MatrixXd F = some_functions(500, 12);
  EXPECT_EQ(CGP::weighted_orthonormalization(F, weights),
            CGP::weighted_orthonormalization(F, weights));
}

TEST(Project_out, leaves_what_is_orthogonal_with_the_weights)
{
  const Eigen::VectorXd weights = some_weights(50);
  const Eigen::MatrixXd F = some_functions(50, 4);
  const Eigen::MatrixXd basis = CGP::weighted_orthonormalization(F, weights);
  const Eigen::VectorXd v = random_numbers(50, 99);
  const Eigen::VectorXd rest = CGP::project_out(basis, weights, v);
  for (int j = 0; j < 4; ++j)
    EXPECT_NEAR((weights.array() * F.col(j).array() * rest.array()).sum(), 0, 1e-14);
  EXPECT_LT((CGP::project_out(basis, weights, rest) - rest).norm(), 1e-15);
  EXPECT_GT(rest.norm(), .5 * v.norm());
}

TEST(Project_out, is_orthogonal_also_where_hardly_anything_remains)
{
  const Eigen::VectorXd weights = some_weights(50);
  const Eigen::MatrixXd basis = CGP::weighted_orthonormalization(some_functions(50, 4), weights);
  const Eigen::VectorXd v = basis.col(0) + basis.col(3) + 1e-13 * random_numbers(50, 99);
  const Eigen::VectorXd rest = CGP::project_out(basis, weights, v);
  const Eigen::VectorXd overlap = basis.transpose() * weights.cwiseProduct(rest);
  EXPECT_LT(overlap.norm(), 1e-14 * rest.norm());
}

TEST(Weighted_orthonormalization, refuses_other_sizes_bad_weights_and_bad_values)
{
  Eigen::VectorXd weights = some_weights(9);
  Eigen::MatrixXd F = some_functions(9, 2);
  EXPECT_EQ(message(F, weights.head(8)), "8 weights, one per row of the functions is needed: 9");
  F(4, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message(F, weights), "function 1 has a value that is not finite");
  weights[5] = -2;
  EXPECT_EQ(message(F, weights), "weight 5 is -2.000000; positive numbers are needed");
  weights[5] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(message(F, weights), "weight 5 is inf; positive numbers are needed");
}

}  // namespace cgp_test::weighted_orthonormalization_tests
