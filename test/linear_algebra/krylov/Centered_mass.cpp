// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/linear_algebra/krylov/Centered_mass.h
#include <Conformal_geometry_processing/linear_algebra/krylov/Centered_mass.h>

#include <gtest/gtest.h>

#include <complex>

#include "support/random.h"

namespace cgp_test::centered_mass_tests {

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

}  // namespace cgp_test::centered_mass_tests
