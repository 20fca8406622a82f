// Tests linear_algebra/direct/Dense_cholesky.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/Dense_cholesky.h>

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <cmath>

#include "linear_algebra/every_unit.h"
#include "support/random.h"

namespace cgp_test::dense_cholesky_tests {

namespace CGP = Conformal_geometry_processing;

Eigen::MatrixXd some_definite_matrix(int n)
{
  Eigen::MatrixXd A(n, n);
  for (int j = 0; j < n; ++j) A.col(j) = random_numbers(n, 20 + static_cast<unsigned>(j));
  return A * A.transpose() + Eigen::MatrixXd::Identity(n, n);
}

// Entries above the diagonal must be ignored.
CGP::internal::Dense_cholesky lower_part(const Eigen::MatrixXd& A)
{
  CGP::internal::Dense_cholesky cholesky;
  const int n = static_cast<int>(A.rows());
  cholesky.set_zero(n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) cholesky(i, j) = i >= j ? A(i, j) : 17 + i;
  return cholesky;
}

TEST(Dense_cholesky, has_the_factor_of_a_matrix)
{
  on_every_unit([&] {
    for (int n : {1, 3, 8, 9, 21, 50}) {
      const Eigen::MatrixXd A = some_definite_matrix(n);
      CGP::internal::Dense_cholesky cholesky = lower_part(A);
      ASSERT_TRUE(cholesky.factorize());
      Eigen::MatrixXd L = Eigen::MatrixXd::Zero(n, n);
      for (int j = 0; j < n; ++j)
        for (int i = j; i < n; ++i) L(i, j) = cholesky(i, j);
      EXPECT_LE((L * L.transpose() - A).norm(), 1e-13 * A.norm()) << n;
    }
  });
}

TEST(Dense_cholesky, solves)
{
  on_every_unit([&] {
    for (int n : {1, 3, 8, 9, 21, 50}) {
      const Eigen::MatrixXd A = some_definite_matrix(n);
      CGP::internal::Dense_cholesky cholesky = lower_part(A);
      ASSERT_TRUE(cholesky.factorize());
      const Eigen::VectorXd b = random_numbers(n, 5);
      Eigen::VectorXd x = b;
      cholesky.solve(x);
      EXPECT_LE((A * x - b).norm(), 1e-11 * b.norm()) << n;
    }
  });
}

TEST(Dense_cholesky, tells_indefinite_matrices)
{
  on_every_unit([&] {
    Eigen::MatrixXd A = some_definite_matrix(20);
    A(19, 19) = -A(19, 19);
    EXPECT_FALSE(lower_part(A).factorize());
    A(19, 19) = std::nan("");
    EXPECT_FALSE(lower_part(A).factorize());
  });
}

TEST(Dense_cholesky, of_no_rows_has_nothing_to_do)
{
  CGP::internal::Dense_cholesky cholesky;
  cholesky.set_zero(0);
  EXPECT_TRUE(cholesky.factorize());
  Eigen::VectorXd none;
  cholesky.solve(none);
  EXPECT_EQ(none.size(), 0);
  EXPECT_EQ(cholesky.bytes(), 0);
}

TEST(Dense_cholesky, gives_its_memory_back)
{
  CGP::internal::Dense_cholesky cholesky = lower_part(some_definite_matrix(8));
  EXPECT_GT(cholesky.bytes(), 0);
  cholesky.release();
  EXPECT_EQ(cholesky.bytes(), 0);
}

}  // namespace cgp_test::dense_cholesky_tests
