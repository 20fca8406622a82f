// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

#include "bounded_flows.h"
#include "support/Counted_solver_traits.h"
#include "support/with_solvers.h"

namespace cgp_test::conformal_willmore_flow_solvers_tests {

/// Requirements of the flow on its solvers, and its behaviour if they fail.

using Flow_stop = CGP::Flow_step_report::Stop;

/// refuses to factor matrices of one kind if told so
struct Watched_solver_traits : Counted_solver_traits {
  enum class Refused { none, real, quaternionic };
  inline static Refused refused = Refused::none;
  inline static CGP::Solver_status status_of_refusal = CGP::Solver_status::numerical_issue;

  template <class Scalar>
  struct Solver : Counted_solver_traits::Solver<Scalar> {
    using Parent = Counted_solver_traits::Solver<Scalar>;
    using Matrix = CGP::Hermitian_sparse_matrix<Scalar>;
    static constexpr Refused kind =
        std::is_same_v<Scalar, double> ? Refused::real : Refused::quaternionic;

    CGP::Solver_status factorize(const Matrix& A, const CGP::Vector<double>& shift)
    {
      const CGP::Solver_status status = Parent::factorize(A, shift);
      return refused == kind ? status_of_refusal : status;
    }
    CGP::Solver_status factorize_preconditioner(const Matrix& A, const CGP::Vector<double>& shift)
    {
      const CGP::Solver_status status = Parent::factorize_preconditioner(A, shift);
      return refused == kind ? status_of_refusal : status;
    }
  };
};

class Conformal_willmore_flow_solvers : public testing::Test {
 protected:
  struct Flow : CGP::Conformal_willmore_flow {
    explicit Flow(const Mesh_view& mesh, const CGP::Flow_options& options = {})
        : Conformal_willmore_flow(mesh, watched(options))
    {}
    static CGP::Flow_options watched(CGP::Flow_options options)
    {
      options.surface = with_solvers<Watched_solver_traits>(options.surface);
      return options;
    }
  };
  using Refused = Watched_solver_traits::Refused;

  ~Conformal_willmore_flow_solvers() override
  {
    Watched_solver_traits::refused = Refused::none;
    Watched_solver_traits::status_of_refusal = CGP::Solver_status::numerical_issue;
  }

  static CGP::Flow_report report_without(Refused refused)
  {
    Watched_solver_traits::refused = refused;
    Flow flow(bumpy_sphere(2));
    return flow.run();
  }
};

TEST_F(Conformal_willmore_flow_solvers, analyze_each_pattern_once_for_all_steps)
{
  CGP::Flow_options options = plain_steps(.5, 3);
  options.filter_weight = .01;
  options.balance = CGP::Flow_options::Balance::canonical;
  options.surface.max_period_defect = 1;  // none to be closed
  Flow flow(btorus(12), options);
  ASSERT_TRUE(flow.step().accepted);
  const int analyses = Watched_solver_traits::analyses();
  const int factorizations = Watched_solver_traits::factorizations();
  EXPECT_EQ(flow.run().steps.size(), 3U);
  EXPECT_EQ(Watched_solver_traits::analyses(), analyses);
  // the Dirac matrices with and without rho, the Laplacian, the filter
  EXPECT_EQ(Watched_solver_traits::factorizations() - factorizations, 3 * 4);
}

TEST_F(Conformal_willmore_flow_solvers, analyze_each_pattern_once_where_there_is_a_boundary)
{
  for (const Boundary_condition& condition :
       {Boundary_condition::binormals(), Boundary_condition::tangents(),
        Boundary_condition::free()}) {
    CGP::Flow_options options = plain_steps(.25, 3, condition);
    options.filter_weight = .01;
    Flow flow(bumpy_annulus(4), options);
    ASSERT_TRUE(flow.step().accepted);
    const int analyses = Watched_solver_traits::analyses();
    EXPECT_EQ(flow.run().steps.size(), 3U);
    EXPECT_EQ(Watched_solver_traits::analyses(), analyses);
  }
}

TEST_F(Conformal_willmore_flow_solvers, factor_two_matrices_in_a_step_of_a_sphere)
{
  Flow flow(bumpy_sphere(2), plain_steps(1, 3));
  const int factorizations = Watched_solver_traits::factorizations();
  EXPECT_EQ(flow.run().steps.size(), 3U);
  EXPECT_EQ(Watched_solver_traits::factorizations() - factorizations, 3 * 2);
}

// Also what trials cost that are not accepted, and snaps to a class.
TEST_F(Conformal_willmore_flow_solvers, are_counted_in_the_report)
{
  CGP::Flow_options large_steps = plain_steps(50, 3);
  large_steps.backtracking = true;
  CGP::Flow_options on_class;
  on_class.max_steps = 3;
  for (const CGP::Flow_options& options : {plain_steps(.5, 3), large_steps, on_class})
    for (const Mesh_view& mesh : {bumpy_sphere(2), btorus(12), bumpy_annulus(4)}) {
      Watched_solver_traits::reset();
      Flow flow(mesh, options);
      int factorizations = 0, solves = 0;
      for (const CGP::Flow_step_report& step : flow.run().steps) {
        factorizations += step.spin.factorizations;
        solves += step.spin.solves;
      }
      EXPECT_GT(solves, 0);
      EXPECT_EQ(factorizations, Watched_solver_traits::quaternionic.factorizations);
      EXPECT_EQ(solves, Watched_solver_traits::quaternionic.solves);
    }
}

TEST_F(Conformal_willmore_flow_solvers, are_named_where_they_fail)
{
  CGP::Flow_report report = report_without(Refused::quaternionic);
  EXPECT_EQ(report.stop, Flow_stop::time_step_too_small);
  EXPECT_NE(report.message.find("factorization of X failed"), std::string::npos) << report.message;
  report = report_without(Refused::real);
  EXPECT_EQ(report.stop, Flow_stop::step_failed);
  EXPECT_NE(report.message.find("factorization of the grounded matrix"), std::string::npos)
      << report.message;
}

TEST_F(Conformal_willmore_flow_solvers, end_the_flow_where_they_run_out_of_memory)
{
  Watched_solver_traits::status_of_refusal = CGP::Solver_status::out_of_memory;
  for (const Refused refused : {Refused::quaternionic, Refused::real}) {
    const int factorizations = Watched_solver_traits::factorizations();
    EXPECT_THROW((void)report_without(refused), CGP::Solver_error);
    EXPECT_LE(Watched_solver_traits::factorizations() - factorizations, 3);  // no smaller step
  }
}

}  // namespace cgp_test::conformal_willmore_flow_solvers_tests
