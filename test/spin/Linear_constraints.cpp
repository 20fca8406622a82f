// Tests include/Conformal_geometry_processing/spin/Linear_constraints.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Linear_constraints.h>

#include <gtest/gtest.h>

#include "support/random.h"

namespace cgp_test::linear_constraints_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Linear_constraints;

Eigen::MatrixXd random_matrix(cgp_test::Random& random, int rows, int columns)
{
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.number(); });
}

/// four constraints of twelve numbers, with K = diag(1, 2, ..., 12)
struct Example {
  cgp_test::Random random{3};
  Eigen::VectorXd K = Eigen::VectorXd::LinSpaced(12, 1, 12);
  Eigen::MatrixXd C = random_matrix(random, 12, 4);
  Eigen::VectorXd c = random_matrix(random, 4, 1);

  Linear_constraints constraints(double damping) const
  {
    return {C, K.cwiseInverse().asDiagonal() * C, Eigen::VectorXd::Constant(4, damping)};
  }
};

TEST(Linear_constraints, are_met_by_the_shortest_step)
{
  Eigen::MatrixXd C(30, 4);
  for (int k = 0; k < 4; ++k) C.col(k) = cgp_test::random_numbers(30, k + 1);
  const Eigen::VectorXd masses = cgp_test::random_numbers(30, 9).cwiseAbs().array() + .1;
  const Eigen::MatrixXd directions = masses.cwiseInverse().asDiagonal() * C;
  const Linear_constraints constraints(C, directions, Eigen::VectorXd::Constant(4, .01));
  const Linear_constraints exact(C, directions, Eigen::VectorXd::Zero(4));
  const Eigen::VectorXd c = cgp_test::random_numbers(4, 10), v = cgp_test::random_numbers(30, 11);
  const Eigen::VectorXd d = constraints.least_solution(c), rest = constraints.project_out(v);
  EXPECT_LT((C.transpose() * d - c).norm(), 1e-2 * c.norm());  // damped
  EXPECT_LT((C.transpose() * exact.least_solution(c) - c).norm(), 1e-10 * c.norm());
  EXPECT_LT((C.transpose() * rest).norm(), 1e-9 * v.norm());
  EXPECT_NEAR(d.dot(masses.cwiseProduct(rest)), 0, 1e-9 * d.norm() * v.norm());
  EXPECT_NEAR(constraints.project_gradient(c[0] * v).dot(v), c[0] * v.dot(rest),
              1e-9 * v.squaredNorm());
}

TEST(Linear_constraints, are_met_the_less_the_more_they_are_damped)
{
  const Example e;
  double last = 0;
  for (const double damping : {.1, 1., 10.}) {
    const Eigen::VectorXd d = e.constraints(damping).least_solution(e.c);
    const double missed = (e.C.transpose() * d - e.c).norm();
    EXPECT_GT(missed, last);
    last = missed;
  }
  EXPECT_LT(last, e.c.norm());
}

// The secant condition, and that nothing else is learned: solutions orthogonal to this one stay.
TEST(Linear_constraints, learn_what_a_solution_has_changed)
{
  Example e;
  Linear_constraints constraints = e.constraints(.1);
  const Eigen::VectorXd d = constraints.least_solution(e.c);
  const Eigen::VectorXd other = constraints.least_solution(random_matrix(e.random, 4, 1));
  const Eigen::VectorXd orthogonal =
      other - d * (other.dot(e.K.cwiseProduct(d)) / d.dot(e.K.cwiseProduct(d)));
  const auto change_of = [&](const Linear_constraints& of, const Eigen::VectorXd& solution) {
    Eigen::MatrixXd solutions(12, 4);
    for (int k = 0; k < 4; ++k) solutions.col(k) = of.least_solution(Eigen::VectorXd::Unit(4, k));
    return Eigen::VectorXd(solutions.colPivHouseholderQr().solve(solution));
  };
  const Eigen::VectorXd before = change_of(constraints, orthogonal);
  const Eigen::VectorXd change = e.c + .2 * random_matrix(e.random, 4, 1);
  constraints.observe(e.c, change);
  EXPECT_LT((constraints.least_solution(change) - d).norm(), 1e-9 * d.norm());
  EXPECT_LT((change_of(constraints, orthogonal) - before).norm(), 1e-9 * before.norm());
}

}  // namespace cgp_test::linear_constraints_tests
