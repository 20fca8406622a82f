// Tests include/Conformal_geometry_processing/linear_algebra/reduced/Schur_reduced_solver.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Schur_reduced_solver.h>

#include "linear_algebra/every_unit.h"
#include "linear_algebra/reduced_solver_laws.h"
#include "threads/threads.h"

namespace cgp_test::schur_reduced_solver_tests {

using Models = testing::Types<CGP::internal::Schur_reduced_solver>;
INSTANTIATE_TYPED_TEST_SUITE_P(Schur, Reduced_solver, Models);

TEST(Schur_reduced_solver, gives_the_same_bits_for_any_number_of_threads)
{
  const Reduced_problem p = reduced_problem(disk(30), 1);
  const CGP::internal::Ordering order = CGP::amd_ordering(p.X.pattern());
  const auto b = random_block<Quaternion<double>>(p.X.size(), 1, 2);
  const auto solution = [&](int threads) {
    const Threads setting(threads);
    CGP::internal::Schur_reduced_solver solver;
    CGP::Block<Quaternion<double>> x;
    EXPECT_EQ(solver.analyze(p.X.pattern(), p.rows(), order), Solver_status::success);
    EXPECT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::success);
    EXPECT_EQ(solver.solve(b, x), Solver_status::success);
    return real_columns(x);
  };
  on_every_unit([&] {
    const Eigen::MatrixXd expected = solution(1);
    for (const int threads : {2, 5}) EXPECT_EQ(solution(threads), expected);
  });
}

TEST(Schur_reduced_solver, solves_on_every_vector_unit)
{
  const Reduced_problem p = reduced_problem(disk(12), 3);
  const auto b = random_block<Quaternion<double>>(p.X.size(), 2, 4);
  const Eigen::MatrixXd expected = p.dense_solution(b);
  on_every_unit([&] {
    CGP::internal::Schur_reduced_solver solver;
    CGP::Block<Quaternion<double>> x;
    ASSERT_EQ(solver.analyze(p.X.pattern(), p.rows(), CGP::amd_ordering(p.X.pattern())),
              Solver_status::success);
    ASSERT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::success);
    ASSERT_EQ(solver.solve(b, x), Solver_status::success);
    EXPECT_LE((real_columns(x) - expected).norm(), 1e-10 * expected.norm());
  });
}

}  // namespace cgp_test::schur_reduced_solver_tests
