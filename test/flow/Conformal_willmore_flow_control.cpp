// Tests flow/Conformal_willmore_flow.h
// Tests flow/Flow_report.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "flow_tools.h"
#include "support/moebius.h"
#include "support/random.h"
#include "support/tori.h"

namespace cgp_test::conformal_willmore_flow_control_tests {

/// Cases in which the flow stops or fails.

using Flow_stop = CGP::Flow_step_report::Stop;

/// a direction without an energy: any step that is conformal enough will do
struct Sideways {
  double factor = 1;
  Eigen::VectorXd operator()(const Mesh_view& mesh) const
  {
    return factor * CGP::mean_curvature(mesh);
  }
};

/// a direction along which its energy grows
struct Uphill : CGP::Willmore_direction {
  Eigen::VectorXd operator()(const Mesh_view& mesh) const { return CGP::mean_curvature(mesh); }
};

/// counts, stops or throws
struct Visitor : CGP::Flow_visitor {
  int begins = 0, ends = 0, iterations = 0;
  int stop_at_iteration = -1, stop_at_end = -1, throw_at_iteration = -1;
  Points last;
  void on_flow_begin(const Mesh_view& mesh, double energy)
  {
    ++begins;
    last = mesh.positions();
    EXPECT_GT(energy, 0);
  }
  void on_iteration(const CGP::Eigensolver_progress&)
  {
    if (iterations++ == throw_at_iteration) throw std::runtime_error("enough");
  }
  bool go_further() const
  {
    return (stop_at_iteration < 0 || iterations <= stop_at_iteration) &&
           (stop_at_end < 0 || ends < stop_at_end);
  }
  void on_step_end(const CGP::Flow_step_report& report, const Mesh_view& mesh)
  {
    EXPECT_EQ(report.step, ++ends);
    last = mesh.positions();
  }
};

TEST(Conformal_willmore_flow_control, halves_the_step_until_it_is_conformal_enough)
{
  CGP::Flow_options options;
  options.surface.exact_conformal_class = false;
  options.max_step_distortion = 1.01;
  CGP::Conformal_willmore_flow flow(bumpy_sphere(3), options);
  const CGP::Flow_step_report step = flow.step();
  EXPECT_TRUE(step.accepted);
  EXPECT_GT(step.trials, 1);
  EXPECT_EQ(step.time_step, std::ldexp(1., 1 - step.trials));
  EXPECT_LT(step.spin.conformality.quasi_conformal.mean, 1.01);
  EXPECT_EQ(flow.step().time_step, 1.5 * step.time_step);
}

TEST(Conformal_willmore_flow_control, balances_at_once_however_small_the_time_step)
{
  const Mesh_view mesh = bumpy_sphere(3), moved = inverted(mesh, {4, .5, .3});
  CGP::Flow_options options;
  options.surface.exact_conformal_class = false;
  options.time_step = .1;
  options.balance = CGP::Flow_options::Balance::prescribed;
  options.target_areas = CGP::vertex_areas(mesh);
  const CGP::internal::Moebius_balancing balancing(options.target_areas);
  for (const auto way :
       {CGP::Flow_options::Balancing::potential, CGP::Flow_options::Balancing::inversion}) {
    options.balancing = way;
    CGP::Conformal_willmore_flow flow(moved, options);
    EXPECT_TRUE(flow.step().accepted);
    EXPECT_LT(balancing.imbalance(flow.mesh()), .3 * balancing.imbalance(moved));
  }
}

TEST(Conformal_willmore_flow_control, gives_up_where_the_energy_rises_and_leaves_the_surface)
{
  const Mesh_view mesh = bumpy_sphere(2);
  CGP::Flow_options options;
  options.fairing = false;
  CGP::Conformal_willmore_flow flow(mesh, options, Uphill());
  const CGP::Flow_report report = flow.run();
  EXPECT_EQ(report.stop, Flow_stop::time_step_too_small);
  EXPECT_FALSE(report);
  EXPECT_NE(report.message.find("the energy rises by"), std::string::npos) << report.message;
  EXPECT_EQ(flow.mesh().positions(), mesh.positions());
  EXPECT_EQ(report.energy, report.initial_energy);
}

TEST(Conformal_willmore_flow_control, takes_a_slight_rise_for_the_minimum)
{
  CGP::Flow_options options;
  options.surface.exact_conformal_class = false;
  options.energy_tolerance = 10;
  CGP::Conformal_willmore_flow flow(bumpy_sphere(2), options, Uphill());
  const CGP::Flow_step_report step = flow.step();
  EXPECT_EQ(step.stop, Flow_stop::energy_settled);
  EXPECT_FALSE(step.accepted);
  EXPECT_EQ(step.trials, 2);
}

TEST(Conformal_willmore_flow_control, does_not_take_small_steps_for_the_end)
{
  CGP::Flow_options options;
  options.time_step = options.min_time_step = 1e-3;
  options.max_steps = 3;
  CGP::Conformal_willmore_flow flow(bumpy_sphere(2), options);
  EXPECT_EQ(flow.run().stop, Flow_stop::steps_done);
  EXPECT_EQ(flow.run().stop, Flow_stop::steps_done);
  EXPECT_EQ(flow.size_of_steps(), 6);
}

TEST(Conformal_willmore_flow_control, follows_directions_without_an_energy)
{
  const Mesh_view mesh = bumpy_sphere(2);
  CGP::Flow_options options;
  options.time_step = 0.2;
  options.max_steps = 2;
  const double before = CGP::willmore_energy(mesh);
  CGP::Conformal_willmore_flow down(mesh, options, Sideways{-1}), up(mesh, options, Sideways{1});
  EXPECT_EQ(down.run().stop, Flow_stop::steps_done);
  EXPECT_EQ(up.run().stop, Flow_stop::steps_done);
  EXPECT_LT(down.energy(), before);
  EXPECT_GT(up.energy(), before);
  EXPECT_NEAR(up.energy() / CGP::willmore_energy(up.mesh()), 1, 1e-14);  // in another frame
}

TEST(Conformal_willmore_flow_control, says_so_where_the_equation_is_not_solved)
{
  CGP::Flow_options options = plain_steps(1, 3);
  options.surface.dirac.max_iterations = 1;
  options.surface.dirac.max_substeps = 1;
  CGP::Conformal_willmore_flow flow(bumpy_sphere(2), options);
  const CGP::Flow_report report = flow.run();
  EXPECT_EQ(report.stop, Flow_stop::step_failed);
  EXPECT_EQ(report.message, "the Dirac equation is not solved");
}

TEST(Conformal_willmore_flow_control, stops_when_the_visitor_says_so)
{
  Visitor after_two;
  after_two.stop_at_end = 2;
  CGP::Conformal_willmore_flow flow(bumpy_sphere(2));
  const CGP::Flow_report report = flow.run(after_two);
  EXPECT_EQ(report.stop, Flow_stop::cancelled);
  EXPECT_FALSE(report);
  EXPECT_EQ(report.steps.size(), 2U);
  EXPECT_EQ(after_two.begins, 1);
  EXPECT_GT(after_two.iterations, 2);
  EXPECT_EQ(flow.mesh().positions(), after_two.last);

  Visitor in_the_midst;
  in_the_midst.stop_at_iteration = after_two.iterations / 2;
  CGP::Conformal_willmore_flow other(bumpy_sphere(2));
  EXPECT_EQ(other.run(in_the_midst).stop, Flow_stop::cancelled);
  EXPECT_EQ(other.mesh().positions(), in_the_midst.last);
}

TEST(Conformal_willmore_flow_control, is_at_the_last_complete_step_when_the_visitor_throws)
{
  const Mesh_view mesh = stretched(perturbed(irregular_torus(2, 1, 24, 12), .02), 2);
  CGP::Conformal_willmore_flow undisturbed(mesh);
  const CGP::Flow_report whole = undisturbed.run();
  for (const int iteration : {7, 8, 9, 12, 30}) {
    Visitor throwing, cancelling;
    throwing.throw_at_iteration = cancelling.stop_at_iteration = iteration;
    CGP::Conformal_willmore_flow flow(mesh), cancelled(mesh);
    EXPECT_THROW((void)flow.run(throwing), std::runtime_error);
    EXPECT_EQ(flow.positions(), throwing.last);
    EXPECT_NEAR(flow.energy() / CGP::willmore_energy(flow.mesh()), 1, 1e-14);  // in another frame
    EXPECT_EQ(cancelled.run(cancelling).stop, Flow_stop::cancelled);
    EXPECT_EQ(flow.run().stop, whole.stop);
    EXPECT_EQ(cancelled.run().stop, whole.stop);
    EXPECT_EQ(flow.size_of_steps(), undisturbed.size_of_steps()) << iteration;
    EXPECT_EQ(flow.mesh().positions(), undisturbed.mesh().positions()) << iteration;
    EXPECT_EQ(cancelled.mesh().positions(), undisturbed.mesh().positions()) << iteration;
  }
}

TEST(Conformal_willmore_flow_control, gives_the_same_bits_twice_and_at_other_scales)
{
  const Mesh_view mesh = bumpy_sphere(2);
  CGP::Conformal_willmore_flow first(mesh), second(mesh), large(scaled(mesh, 1024));
  (void)first.run();
  (void)second.run();
  (void)large.run();
  EXPECT_EQ(first.mesh().positions(), second.mesh().positions());
  EXPECT_EQ(large.mesh().positions(), 1024 * first.mesh().positions());
}

}  // namespace cgp_test::conformal_willmore_flow_control_tests
