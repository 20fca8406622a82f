// Tests include/Conformal_geometry_processing/linear_algebra/reduced/Reduced_complement.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/reduced/Reduced_complement.h>

#include <gtest/gtest.h>

#include "linear_algebra/reduced_problem.h"

namespace cgp_test::reduced_complement_tests {

using Q = Quaternion<double>;

/// all rows of the vector reduced, so that nothing is eliminated
Reduced_problem nothing_else()
{
  return reduced_problem(random_pattern(9, 1), {0, 1, 2, 3, 4, 5, 6, 7, 8}, 2);
}

TEST(Reduced_complement, of_nothing_eliminated_is_the_reduced_matrix)
{
  const Reduced_problem p = nothing_else();
  const CGP::internal::Supernodal_structure structure(p.X.pattern(), random_permutation(9, 3), 9);
  CGP::internal::Reduced_complement complement(p.X.pattern(), structure);
  complement.assemble(p.X, p.shift, p.basis());
  ASSERT_TRUE(complement.factorize());
  const CGP::Block<Q> b = random_block<Q>(9, 1, 4);
  CGP::Vector<Q> y(9);
  for (int k = 0; k < 9; ++k) y[k] = b(structure.order()[at(k)]);
  complement.solve(y);
  CGP::Block<Q> x(9, 1);
  for (int k = 0; k < 9; ++k) x(structure.order()[at(k)]) = y[k];
  const Eigen::MatrixXd expected = p.dense_solution(b);
  EXPECT_LE((real_columns(x) - expected).norm(), 1e-13 * expected.norm());
}

TEST(Reduced_complement, knows_whether_it_is_definite)
{
  const Reduced_problem p = nothing_else();
  const CGP::internal::Supernodal_structure structure(p.X.pattern(), random_permutation(9, 5), 9);
  CGP::internal::Reduced_complement complement(p.X.pattern(), structure);
  complement.assemble(p.X, -10 * p.X.diagonal(0) * Eigen::VectorXd::Ones(9), p.basis());
  EXPECT_FALSE(complement.factorize());
  complement.assemble(p.X, {}, p.basis());
  EXPECT_TRUE(complement.factorize());
}

TEST(Reduced_complement, knows_its_size)
{
  const Reduced_problem p = nothing_else();
  const CGP::internal::Supernodal_structure structure(p.X.pattern(), random_permutation(9, 6), 4);
  const CGP::internal::Reduced_complement complement(p.X.pattern(), structure);
  EXPECT_EQ(complement.factor_entries(), 36);
  EXPECT_EQ(complement.bytes(), 64. * sizeof(double));
  EXPECT_NEAR(complement.flops(), 512 / 3., 1e-9);
}

}  // namespace cgp_test::reduced_complement_tests
