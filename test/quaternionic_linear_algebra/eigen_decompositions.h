// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdint>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test {

/// a dense Hermitian matrix
template <class Scalar = Quaternion<double>>
CGP::Block<Scalar> random_hermitian_block(int d, std::uint64_t seed)
{
  using Traits = CGP::internal::Scalar_traits<Scalar>;
  CGP::Block<Scalar> A = random_block<Scalar>(d, d, seed);
  for (int j = 0; j < d; ++j) {
    A(j, j) = Traits::from_real(Traits::real(A(j, j)));
    for (int i = 0; i < j; ++i) A(j, i) = CGP::conjugate(A(i, j));
  }
  return A;
}

/// A V = V D with orthonormal V and ascending D
template <class Decomposition, class Scalar>
void expect_decomposition(const Decomposition& e, const CGP::Block<Scalar>& A, double tolerance,
                          double tolerance_of_vectors)
{
  const Eigen::Index d = A.rows();
  ASSERT_EQ(e.values.size(), d);
  const Eigen::MatrixXd V = real_form(e.vectors);
  const Eigen::Index n = V.rows(), components = d > 0 ? n / d : 1;
  const Eigen::MatrixXd D = e.values.transpose().replicate(components, 1).reshaped().asDiagonal();
  EXPECT_LE((real_form(A) * V - V * D).norm(), tolerance);
  EXPECT_LE((V.transpose() * V - Eigen::MatrixXd::Identity(n, n)).norm(), tolerance_of_vectors);
  for (Eigen::Index i = 1; i < d; ++i) EXPECT_LE(e.values[i - 1], e.values[i]);
}

}  // namespace cgp_test
