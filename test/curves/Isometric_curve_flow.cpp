// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Isometric_curve_flow.h>

#include <gtest/gtest.h>

#include "support/plane_curves.h"

#include <stdexcept>

namespace cgp_test::isometric_curve_flow_tests {

namespace CGP = Conformal_geometry_processing;

CGP::Curve_flow_options with(double tau, int steps)
{
  CGP::Curve_flow_options options;
  options.time_step = tau;
  options.max_steps = steps;
  options.energy_tolerance = 0;
  return options;
}

Curve flown(const Curve& curve, const CGP::Curve_flow_options& options)
{
  CGP::Isometric_curve_flow flow(curve, options);
  CGP::Curve_flow_visitor silent;
  (void)flow.run(silent);
  return flow.points();
}

double difference(const Curve& a, const Curve& b)
{
  return (a - b).cwiseAbs().maxCoeff();
}

Eigen::Vector2d centroid(const Curve& curve)
{
  return curve * CGP::internal::Polygon_lengths(curve, true).duals() / length_of(curve);
}

TEST(Isometric_curve_flow, keeps_every_length_to_a_trillionth)
{
  for (const Curve& curve : {flower(200), ellipse(200), figure_eight(200), limacon(200), rose(200)})
    for (const double tau : {.1, .25, .5, .75}) {
      const Curve result = flown(curve, with(tau, 30));
      EXPECT_LT(distortion(curve, result), 1e-12) << tau;
    }
  EXPECT_LT(distortion(flower(2000), flown(flower(2000), with(.25, 10))), 1e-12);
}

TEST(Isometric_curve_flow, keeps_the_turning_number)
{
  for (const Curve& curve : {flower(200), figure_eight(200), limacon(200), rose(200)}) {
    CGP::Isometric_curve_flow flow(curve, with(.5, 10));
    const double turns = turns_of(curve);
    EXPECT_NEAR(flow.turning_number_of_curve(), turns, 1e-12);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(flow.step().turning_number, std::lround(turns));
    EXPECT_NEAR(turns_of(flow.points()), turns, 1e-12);
  }
}

TEST(Isometric_curve_flow, energy_falls_in_every_step_and_is_that_of_the_points)
{
  for (const Curve& curve : {flower(200), figure_eight(200), rose(100)})
    for (const double tau : {.1, .5, .9}) {
      CGP::Isometric_curve_flow flow(curve, with(tau, 10));
      double before = flow.energy();
      EXPECT_NEAR(before * flow.length() / energy_times_length(curve), 1, 1e-12);
      for (int i = 0; i < 10; ++i) {
        const CGP::Curve_step_report step = flow.step();
        ASSERT_TRUE(step.accepted);
        EXPECT_EQ(step.step, i + 1);
        EXPECT_EQ(step.energy_before, before);
        EXPECT_LE(step.energy, before * (1 + 1e-9));
        EXPECT_NEAR(step.energy * flow.length() / energy_times_length(flow.points()), 1, 1e-9);
        before = step.energy;
      }
    }
}

TEST(Isometric_curve_flow, centroid_stays_and_the_curve_does_not_spin)
{
  const Curve curve = flower(200).colwise() + Eigen::Vector2d(5, -3);
  const Curve result = flown(curve, with(.1, 20));
  EXPECT_LT((centroid(result) - centroid(curve)).norm(), 1e-12);
  double spin = 0;
  for (Eigen::Index i = 0; i < 200; ++i) {
    const Eigen::Vector2d p = curve.col(i) - centroid(curve), q = result.col(i) - centroid(result);
    spin += std::arg(std::complex(q.x(), q.y()) / std::complex(p.x(), p.y())) / 200;
  }
  EXPECT_LT(std::abs(spin), 0.05);
}

TEST(Isometric_curve_flow, depends_neither_on_place_nor_on_size_nor_on_direction)
{
  const Curve curve = figure_eight(100);
  const Curve result = flown(curve, with(.3, 5));
  Eigen::Matrix2d turn;
  turn << std::cos(1.), -std::sin(1.), std::sin(1.), std::cos(1.);
  EXPECT_LT(difference(flown(turn * curve, with(.3, 5)), turn * result), 1e-11);
  for (const double scale : {1e-200, 3., 1e200})
    EXPECT_LT(difference(flown(scale * curve, with(.3, 5)) / scale, result), 1e-11) << scale;
  const Eigen::Vector2d far(1e6, -2e6);
  EXPECT_LT(difference(flown(curve.colwise() + far, with(.3, 5)).colwise() - far, result), 1e-7);
  const Curve mirrored = Eigen::Vector2d(1, -1).asDiagonal() * curve;
  EXPECT_LT(difference(flown(mirrored, with(.3, 5)), Eigen::Vector2d(1, -1).asDiagonal() * result),
            1e-11);
}

TEST(Isometric_curve_flow, does_not_depend_on_the_numbering)
{
  const Curve curve = rose(100);
  const Curve result = flown(curve, with(.3, 5));
  Curve renumbered(2, 100), expected(2, 100);
  for (Eigen::Index i = 0; i < 100; ++i) {
    renumbered.col(i) = curve.col((i + 37) % 100);
    expected.col(i) = result.col((i + 37) % 100);
  }
  EXPECT_LT(difference(flown(renumbered, with(.3, 5)), expected), 1e-11);
  const Curve reversed = curve.rowwise().reverse();
  EXPECT_LT(difference(flown(reversed, with(.3, 5)).rowwise().reverse(), result), 1e-11);
}

// Near a circle, a wave of curvature is multiplied by 1 - 2 tau: 1/2 takes it away, 1 is the limit.
TEST(Isometric_curve_flow, a_wave_on_a_circle_is_multiplied_by_one_minus_two_tau)
{
  const Curve curve =
      sampled(90, [](double t) { return std::polar(1 + 1e-6 * std::cos(3 * t), t); });
  const auto wave = [](const Curve& c) {
    const Eigen::VectorXd kappa = curvatures_of(c);
    return Eigen::VectorXd(kappa.array() - kappa.mean());
  };
  for (const double tau : {.01, .1, .3, .5, .75, .95, .99}) {
    const Curve result = flown(curve, with(tau, 1));
    EXPECT_LT((wave(result) - (1 - 2 * tau) * wave(curve)).norm(), 1e-4 * wave(curve).norm())
        << tau;
  }
}

TEST(Isometric_curve_flow, energies_of_open_curves_fall_by_the_square_of_one_minus_two_tau)
{
  const Curve curve = flower(200).leftCols(150);
  for (const double tau : {.1, .25, .4, .9}) {
    CGP::Curve_flow_options options = with(tau, 5);
    options.is_closed = false;
    CGP::Isometric_curve_flow flow(curve, options);
    for (int i = 0; i < 5; ++i) {
      const CGP::Curve_step_report step = flow.step();
      EXPECT_NEAR(step.energy / step.energy_before, (1 - 2 * tau) * (1 - 2 * tau), 1e-12);
      EXPECT_EQ(step.gap, 0);
    }
    const CGP::internal::Polygon_lengths lengths(curve, false);
    EXPECT_LT(CGP::length_distortion(flow.points(), lengths), 1e-13);
    EXPECT_EQ(flow.turning_number_of_curve(), 0);
  }
}

TEST(Isometric_curve_flow, open_curves_become_straight_in_one_step_of_a_half)
{
  CGP::Curve_flow_options options = with(.5, 1);
  options.is_closed = false;
  const Curve line = flown(flower(200).leftCols(150), options);
  const double length = CGP::internal::Polygon_lengths(line, false).total();
  EXPECT_NEAR((line.col(149) - line.col(0)).norm(), length, 1e-12 * length);
}

TEST(Isometric_curve_flow, stops_where_the_energy_has_settled)
{
  for (const Curve& curve : {flower(200), figure_eight(200)}) {
    CGP::Isometric_curve_flow flow(curve);
    CGP::Curve_flow_visitor silent;
    const CGP::Curve_flow_report report = flow.run(silent);
    EXPECT_EQ(report.stop, CGP::Curve_step_report::Stop::energy_settled);
    EXPECT_TRUE(report.converged() && report);
    EXPECT_LT(report.steps.size(), 20u);
    EXPECT_EQ(report.steps.back().stop, CGP::Curve_step_report::Stop::energy_settled);
    EXPECT_EQ(report.energy, report.steps.back().energy);
    EXPECT_EQ(report.energy, flow.energy());
    EXPECT_GT(report.initial_energy, report.energy);
    EXPECT_LT(report.length_distortion, 1e-12);
    EXPECT_NEAR(report.length, length_of(curve), 1e-12);
  }
}

struct Counting_visitor : CGP::Curve_flow_visitor {
  void on_flow_begin(const Curve& points, double energy)
  {
    EXPECT_EQ(points.cols(), 100);
    EXPECT_GT(energy, 0);
    ++begins;
  }
  bool go_further() { return ++questions <= limit; }
  void on_step_end(const CGP::Curve_step_report& step, const Curve& points)
  {
    EXPECT_EQ(step.step, ++steps);
    last = points;
    if (steps == bad_step) throw std::runtime_error("no more");
  }
  int limit = 1000, bad_step = 0, begins = 0, questions = 0, steps = 0;
  Curve last;
};

TEST(Isometric_curve_flow, makes_the_steps_it_is_asked_for)
{
  Counting_visitor visitor;
  CGP::Isometric_curve_flow flow(flower(100), with(.1, 4));
  const CGP::Curve_flow_report report = flow.run(visitor);
  EXPECT_EQ(report.stop, CGP::Curve_step_report::Stop::steps_done);
  EXPECT_TRUE(report && !report.converged());
  EXPECT_EQ(report.steps.size(), 4u);
  EXPECT_EQ(visitor.begins, 1);
  EXPECT_EQ(visitor.steps, 4);
  EXPECT_EQ(visitor.last, flow.points());
}

TEST(Isometric_curve_flow, stops_at_the_last_complete_step_when_told_to)
{
  Counting_visitor visitor;
  visitor.limit = 2;
  CGP::Isometric_curve_flow flow(flower(100), with(.1, 4));
  const CGP::Curve_flow_report report = flow.run(visitor);
  EXPECT_EQ(report.stop, CGP::Curve_step_report::Stop::cancelled);
  EXPECT_FALSE(report);
  EXPECT_EQ(report.steps.size(), 2u);
  EXPECT_EQ(flow.points(), flown(flower(100), with(.1, 2)));
}

TEST(Isometric_curve_flow, refuses_to_be_called_by_its_own_visitor)
{
  struct Intruder : CGP::Curve_flow_visitor {
    CGP::Isometric_curve_flow* flow = nullptr;
    int refused = 0;
    bool go_further()
    {
      CGP::Curve_flow_visitor silent;
      EXPECT_THROW((void)flow->step(), CGP::Precondition_error);
      EXPECT_THROW((void)flow->run(silent), CGP::Precondition_error);
      ++refused;
      return true;
    }
  } intruder;
  CGP::Isometric_curve_flow flow(flower(100), with(.1, 4));
  intruder.flow = &flow;
  EXPECT_EQ(flow.run(intruder).steps.size(), 4u);
  EXPECT_EQ(intruder.refused, 4);
  EXPECT_EQ(flow.points(), flown(flower(100), with(.1, 4)));
}

TEST(Isometric_curve_flow, stays_at_its_last_step_when_the_visitor_throws)
{
  Counting_visitor visitor;
  visitor.bad_step = 2;
  CGP::Isometric_curve_flow flow(flower(100), with(.1, 4));
  EXPECT_THROW((void)flow.run(visitor), std::runtime_error);
  EXPECT_EQ(flow.points(), flown(flower(100), with(.1, 2)));
}

// A triangle is as stiff as its edges are: there is nothing to flow, and no reason to fail.
TEST(Isometric_curve_flow, leaves_triangles_as_they_are)
{
  Curve triangle(2, 3);
  triangle << 0, 3, 1, 0, 0, 2;
  CGP::Isometric_curve_flow flow(triangle);
  CGP::Curve_flow_visitor silent;
  const CGP::Curve_flow_report report = flow.run(silent);
  EXPECT_EQ(report.stop, CGP::Curve_step_report::Stop::energy_settled);
  EXPECT_LT(difference(flow.points(), triangle), 1e-12);
}

TEST(Isometric_curve_flow, tries_smaller_steps_where_the_energy_would_rise)
{
  // Curves that do not turn are not at rest at large time steps.
  CGP::Isometric_curve_flow flow(figure_eight(200), with(.95, 1));
  int trials = 0;
  for (int i = 0; i < 60; ++i) trials = std::max(trials, flow.step().trials);
  EXPECT_GT(trials, 1);
  EXPECT_NEAR(flow.energy() * flow.length(), 112.4239, 1);
}

TEST(Isometric_curve_flow, options_out_of_range_are_refused)
{
  for (const double tau : {0., -.1, 1., 1.5, std::nan("")})
    EXPECT_THROW((void)flown(flower(50), with(tau, 1)), CGP::Precondition_error) << tau;
  EXPECT_THROW((void)flown(flower(50), with(.5, -1)), CGP::Precondition_error);
  CGP::Curve_flow_options options;
  options.energy_tolerance = -1;
  EXPECT_THROW((void)flown(flower(50), options), CGP::Precondition_error);
  EXPECT_THROW((void)flown(flower(2), {}), CGP::Precondition_error);
}

}  // namespace cgp_test::isometric_curve_flow_tests
