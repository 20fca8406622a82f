// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests reduced/Reduced_hermitian_solver.h
#include <Quaternionic_linear_algebra/adapters/Eigen_hermitian_solver_traits.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>

#include <gtest/gtest.h>

#include "quaternionic_linear_algebra/reduced_problem.h"
#include "quaternionic_linear_algebra/reduced_solver_laws.h"

namespace cgp_test::real_reduced_solver_tests {

Eigen::MatrixXd reduced(const Reduced_problem& p)
{
  CGP::Hermitian_sparse_matrix<double> R(CGP::reduced_pattern(p.X.pattern(), p.rows()));
  CGP::assemble_reduced_matrix(p.X, p.basis(), R);
  return real_form(plus_diagonal(R, CGP::reduced_diagonal(p.shift, p.rows())));
}

TEST(Reduced_matrix, is_the_product_with_the_basis_on_both_sides)
{
  for (const std::vector<int>& rows :
       {std::vector<int>{}, {4}, {0, 9, 5, 6}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
    const Reduced_problem p = reduced_problem(random_pattern(10, 1), rows, 2);
    const Eigen::MatrixXd expected = p.dense_matrix();
    EXPECT_LE((reduced(p) - expected).norm(), 1e-14 * expected.norm());
  }
}

TEST(Reduced_matrix, of_a_disk_is_the_product_with_the_basis_on_both_sides)
{
  const Reduced_problem p = reduced_problem(disk(3), 3);
  const Eigen::MatrixXd expected = p.dense_matrix();
  EXPECT_LE((reduced(p) - expected).norm(), 1e-14 * expected.norm());
}

TEST(Reduced_matrix, has_a_pattern_with_the_diagonal_first_and_rows_ascending)
{
  const Reduced_problem p = reduced_problem(disk(2), 4);
  const auto pattern = CGP::reduced_pattern(p.X.pattern(), p.rows());
  ASSERT_EQ(pattern->size(), p.rows().dimension());
  for (int j = 0; j < pattern->size(); ++j) {
    const int begin = pattern->offsets[at(j)], end = pattern->offsets[at(j + 1)];
    EXPECT_EQ(pattern->indices[at(begin)], j);
    for (int k = begin + 1; k < end; ++k)
      EXPECT_LT(pattern->indices[at(k - 1)], pattern->indices[at(k)]);
  }
}

TEST(Reduced_ordering, keeps_the_coordinates_of_a_row_together)
{
  const CGP::internal::Reduced_rows rows(3, {1});
  EXPECT_EQ(CGP::reduced_ordering({2, 1, 0}, rows),
            (CGP::internal::Ordering{6, 7, 8, 9, 4, 5, 0, 1, 2, 3}));
}

struct Over_eigen : CGP::internal::Real_reduced_solver {
  Over_eigen()
      : Real_reduced_solver(
            CGP::Spin_solvers(CGP::Eigen_hermitian_solver_traits()).solver<double>())
  {}
};

using Models = testing::Types<CGP::internal::Real_reduced_solver, Over_eigen>;
INSTANTIATE_TYPED_TEST_SUITE_P(Real, Reduced_solver, Models);

}  // namespace cgp_test::real_reduced_solver_tests
