// Tests include/Conformal_geometry_processing/spin/Constraint_basis.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/spin/Constraint_basis.h>

#include <gtest/gtest.h>

#include "support/random.h"

namespace cgp_test::constraint_basis_tests {

namespace CGP = Conformal_geometry_processing;

constexpr int n = 50;

Eigen::VectorXd some_areas()
{
  return (random_numbers(n, 1).array() + 2).matrix();
}

Eigen::MatrixXd random_functions(int k, std::uint64_t seed)
{
  return Eigen::Map<const Eigen::MatrixXd>(random_numbers(n * k, seed).eval().data(), n, k);
}

double product(const Eigen::VectorXd& a, const Eigen::VectorXd& b)
{
  return (some_areas().array() * a.array() * b.array()).sum();
}

TEST(Constraint_basis, leaves_nothing_along_any_group)
{
  const Eigen::MatrixXd a = random_functions(3, 2), b = 1e-6 * random_functions(4, 3);
  CGP::internal::Constraint_basis basis(some_areas());
  basis.add(a);
  basis.add(b);
  EXPECT_EQ(basis.rank(), 7);
  const Eigen::VectorXd v = basis.project_out(random_numbers(n, 4));
  EXPECT_GT(basis.norm(v), 1);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(product(a.col(k), v), 0, 1e-12);
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(product(b.col(k), v), 0, 1e-18);
}

TEST(Constraint_basis, takes_away_what_lies_in_it_and_nothing_else)
{
  const Eigen::MatrixXd a = random_functions(3, 2);
  CGP::internal::Constraint_basis basis(some_areas());
  basis.add(a);
  EXPECT_LT(basis.norm(basis.project_out(a * Eigen::Vector3d(1, -2, 3))), 1e-13);
  const Eigen::VectorXd v = basis.project_out(random_numbers(n, 4));
  const Eigen::VectorXd both = v + a * Eigen::Vector3d(5, 0, 1);
  EXPECT_LT((basis.project_out(both) - v).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(Constraint_basis, drops_what_depends_on_other_functions)
{
  const Eigen::MatrixXd a = random_functions(3, 2);
  Eigen::MatrixXd b = 1e-6 * random_functions(2, 3);
  CGP::internal::Constraint_basis basis(some_areas());
  basis.add(a);
  basis.add(a.col(0) - 2 * a.col(2) + 1e-5 * random_functions(1, 5));
  EXPECT_EQ(basis.rank(), 3);
  b.col(1) = b.col(0);
  basis.add(b);
  EXPECT_EQ(basis.rank(), 4);
}

TEST(Constraint_basis, is_empty_at_first)
{
  const CGP::internal::Constraint_basis basis(some_areas());
  const Eigen::VectorXd v = random_numbers(n, 4);
  EXPECT_EQ(basis.rank(), 0);
  EXPECT_EQ(basis.project_out(v), v);
  EXPECT_NEAR(basis.norm(v), std::sqrt(product(v, v)), 1e-13);
}

TEST(Constraint_basis, refuses_functions_of_another_size)
{
  CGP::internal::Constraint_basis basis(some_areas());
  EXPECT_THROW(basis.add(Eigen::MatrixXd::Ones(n + 1, 1)), CGP::Precondition_error);
}

}  // namespace cgp_test::constraint_basis_tests
