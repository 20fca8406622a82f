// Tests include/Conformal_geometry_processing/linear_algebra/reduced/Reduced_hermitian_solver.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Reduced_hermitian_solver.h>

#include "linear_algebra/reduced_solver_laws.h"

namespace cgp_test::reduced_hermitian_solver_tests {

using CGP::internal::Reduced_hermitian_solver;
using Q = Quaternion<double>;

using Models = testing::Types<Reduced_hermitian_solver>;
INSTANTIATE_TYPED_TEST_SUITE_P(Automatic, Reduced_solver, Models);

template <class Solver>
Eigen::MatrixXd solution(const Reduced_problem& p, const CGP::Block<Q>& b)
{
  Solver solver;
  EXPECT_EQ(solver.analyze(p.X.pattern(), p.rows(), CGP::amd_ordering(p.X.pattern())),
            Solver_status::success);
  EXPECT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::success);
  CGP::Block<Q> x;
  EXPECT_EQ(solver.solve(b, x), Solver_status::success);
  return real_columns(x);
}

TEST(Reduced_hermitian_solver, has_two_forms_that_agree)
{
  for (const Mesh_view& mesh : {disk(12), annulus(1, 2, 60, 10), grid(60, 4)}) {
    const Reduced_problem p = reduced_problem(mesh, 1);
    const auto b = random_block<Q>(p.X.size(), 2, 2);
    const Eigen::MatrixXd real = solution<CGP::internal::Real_reduced_solver>(p, b);
    EXPECT_LE((solution<CGP::internal::Schur_reduced_solver>(p, b) - real).norm(),
              1e-11 * real.norm());
    EXPECT_LE((solution<Reduced_hermitian_solver>(p, b) - real).norm(), 1e-11 * real.norm());
  }
}

TEST(Reduced_hermitian_solver, takes_the_form_that_suits_the_mesh)
{
  for (const bool is_strip : {false, true}) {
    const Mesh_view mesh = is_strip ? grid(200, 3, 200, 3) : disk(8);
    const Reduced_problem p = reduced_problem(mesh, 3);
    const auto b = random_block<Q>(p.X.size(), 1, 4);
    Reduced_hermitian_solver solver;
    for (const bool with_positions : {false, true}) {
      ASSERT_EQ(with_positions
                    ? solver.analyze_with_positions(p.X.pattern(), p.rows(), mesh.positions())
                    : solver.analyze(p.X.pattern(), p.rows()),
                Solver_status::success);
      EXPECT_EQ(solver.has_real_form(), is_strip);
      ASSERT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::success);
      const Eigen::MatrixXd expected = solution<CGP::internal::Real_reduced_solver>(p, b);
      EXPECT_LE((real_columns(CGP::inverse_operator(solver)(b)) - expected).norm(),
                1e-11 * expected.norm());
    }
  }
}

TEST(Reduced_hermitian_solver, refuses_positions_and_rows_of_another_mesh)
{
  const Reduced_problem p = reduced_problem(disk(3), 5);
  Reduced_hermitian_solver solver;
  EXPECT_EQ(solver.analyze_with_positions(p.X.pattern(), p.rows(), Eigen::Matrix3Xd(3, 2)),
            Solver_status::wrong_state);
  EXPECT_EQ(solver.analyze(p.X.pattern(), CGP::internal::Reduced_rows(2, {})),
            Solver_status::wrong_state);
  EXPECT_EQ(solver.factorize(p.X, p.shift, p.basis()), Solver_status::wrong_state);
}

}  // namespace cgp_test::reduced_hermitian_solver_tests
