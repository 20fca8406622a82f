// Tests linear_algebra/krylov/Eigensolver_result.h, linear_algebra/krylov/Eigensolver_result.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/krylov/Eigensolver_result.h>

#include <gtest/gtest.h>

#include <limits>

#include "linear_algebra/spectral_problem.h"

namespace cgp_test::eigensolver_convergence_tests {

namespace CGP = Conformal_geometry_processing;
using Q = CGP::Quaternion<double>;
using Block = CGP::Block<Q>;

// Feeds iterates of dimension two: the vector is (1, 0), the residual (0, size).
class Iteration {
 public:
  explicit Iteration(const CGP::Eigensolver_options& options = {})
      : m_convergence("run", options, Block(2, 1))
  {}

  bool is_last(double theta, double size)
  {
    const CGP::internal::Ritz_panel x = panel(theta);
    Block r(2, 1);
    r(1, 0).w = size;
    m_convergence.count_solve();
    const bool last = m_convergence.is_last(x, r, r, m_go_further);
    if (!last) m_convergence.count_iteration();
    return last;
  }

  bool has_adapted(double theta) { return m_convergence.has_adapted(panel(theta).v); }

  CGP::Eigensolver_result result() { return m_convergence.result(); }

 private:
  static CGP::internal::Ritz_panel panel(double theta)
  {
    CGP::internal::Ritz_panel x{Block(2, 1), Block(2, 1), Block(2, 1)};
    x.v(0, 0).w = x.nv(0, 0).w = 1;
    x.kv(0, 0).w = theta;
    return x;
  }

  CGP::internal::Eigensolver_convergence m_convergence;
  CGP::internal::Always_go_further m_go_further;
};

TEST(Eigensolver_convergence, stops_below_the_tolerance)
{
  Iteration run;
  EXPECT_FALSE(run.is_last(3, 1));
  EXPECT_FALSE(run.is_last(2, 1.1e-6));
  EXPECT_TRUE(run.is_last(1, 0.9e-6));
  const auto r = run.result();
  EXPECT_TRUE(r.converged);
  EXPECT_EQ(r.iterations, 2);
  EXPECT_EQ(r.solves, 3);
  EXPECT_EQ(r.values[0], 1);
  EXPECT_NEAR(r.estimates[0], 0.9e-6, 1e-20);
  EXPECT_FALSE(r.gap.has_value());
}

TEST(Eigensolver_convergence, measures_in_the_given_scale)
{
  CGP::Eigensolver_options options;
  options.scale = 1e-3;
  Iteration run(options);
  EXPECT_FALSE(run.is_last(1, 1.1e-9));
  EXPECT_TRUE(run.is_last(1, 0.9e-9));
}

TEST(Eigensolver_convergence, keeps_the_best_iterate)
{
  CGP::Eigensolver_options options;
  options.max_iterations = 2;
  Iteration run(options);
  EXPECT_FALSE(run.is_last(5, 1e-3));
  EXPECT_FALSE(run.is_last(4, 1e-5));
  EXPECT_TRUE(run.is_last(3, 1e-4));
  const auto r = run.result();
  EXPECT_FALSE(r.converged);
  EXPECT_EQ(r.values[0], 4);
  EXPECT_NEAR(r.estimates[0], 1e-5, 1e-18);
}

TEST(Eigensolver_convergence, sees_stagnation_after_three_steps_without_progress)
{
  Iteration run;
  EXPECT_FALSE(run.is_last(1, 1e-5));
  EXPECT_FALSE(run.is_last(1, 2e-5));
  EXPECT_FALSE(run.is_last(1, 1e-5));
  EXPECT_TRUE(run.is_last(1, 3e-5));
  EXPECT_TRUE(run.result().stagnated);
}

TEST(Eigensolver_convergence, waits_while_the_eigenvalue_still_falls)
{
  Iteration run;
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(run.is_last(2 - 0.01 * i, 1e-3 + 1e-5 * i));
}

TEST(Eigensolver_convergence, does_not_compare_iterates_of_different_matrices)
{
  CGP::Eigensolver_options options;
  double estimate = 0;
  bool changes = false;
  options.adapt = [&](const CGP::Eigensolver_progress& progress) {
    estimate = progress.estimate;
    return changes;
  };
  Iteration run(options);
  EXPECT_FALSE(run.is_last(1, 1e-5));
  EXPECT_FALSE(run.has_adapted(1));
  EXPECT_NEAR(estimate, 1e-5, 1e-18);
  for (int i = 0; i < 2; ++i) EXPECT_FALSE(run.is_last(1, 2e-5));
  changes = true;
  EXPECT_TRUE(run.has_adapted(1));
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(run.is_last(5, 3e-5));  // no stagnation yet
  EXPECT_TRUE(run.is_last(5, 3e-5));
  const auto r = run.result();
  EXPECT_EQ(r.values[0], 5);
  EXPECT_NEAR(r.estimates[0], 3e-5, 1e-18);
}

TEST(Eigensolver_convergence, does_not_count_errors_along_the_vector)
{
  // T r = r + 1e6 x, as an inverse of a nearly singular matrix may give.
  const CGP::Eigensolver_options options;
  CGP::internal::Eigensolver_convergence convergence("run", options, Block(2, 1));
  CGP::internal::Ritz_panel x{Block(2, 1), Block(2, 1), Block(2, 1)};
  x.v(0, 0).w = x.nv(0, 0).w = x.kv(0, 0).w = 1;
  Block r(2, 1), Tr(2, 1);
  r(0, 0) = {1e-10, 1e-10, 0, 0};
  r(1, 0).w = Tr(1, 0).w = 1e-4;
  Tr(0, 0) = {1e6, 1e6, 0, 0};
  CGP::internal::Always_go_further always;
  EXPECT_FALSE(convergence.is_last(x, r, Tr, always));
  EXPECT_NEAR(convergence.result().estimates[0], 1e-4, 1e-16);
}

TEST(Eigensolver_convergence, refuses_values_that_are_not_finite)
{
  Iteration run;
  EXPECT_THROW(run.is_last(1, std::numeric_limits<double>::quiet_NaN()), CGP::Solver_error);
}

TEST(Eigensolver_convergence, refuses_fewer_vectors_than_wanted)
{
  CGP::Eigensolver_options options;
  options.wanted = 2;
  EXPECT_THROW(Iteration{options}, CGP::Precondition_error);
  options.wanted = 0;
  EXPECT_THROW(Iteration{options}, CGP::Precondition_error);
}

TEST(Eigensolver_result, starts_without_success)
{
  const CGP::Eigensolver_result r;
  EXPECT_FALSE(r.converged || r.stagnated || r.cancelled);
  EXPECT_EQ(r.iterations, 0);
}

}  // namespace cgp_test::eigensolver_convergence_tests
