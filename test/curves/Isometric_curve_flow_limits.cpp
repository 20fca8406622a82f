// Tests curves/Isometric_curve_flow.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/Isometric_curve_flow.h>

#include <gtest/gtest.h>

#include "support/plane_curves.h"

namespace cgp_test::isometric_curve_flow_limits_tests {

// Where curves flow to and how much is lost on the way: the numbers of an independent reference.

namespace CGP = Conformal_geometry_processing;

Curve flown(const Curve& curve, double tau, int steps,
            CGP::Curve_flow_options::Closing closing = CGP::Curve_flow_options::Closing::exact)
{
  CGP::Curve_flow_options options;
  options.time_step = tau;
  options.closing = closing;
  CGP::Isometric_curve_flow flow(curve, options);
  for (int i = 0; i < steps; ++i) (void)flow.step();
  return flow.points();
}

constexpr CGP::Curve_flow_options::Closing least_squares =
    CGP::Curve_flow_options::Closing::least_squares;

/// the complete elliptic integrals of the parameter m, by the arithmetic-geometric mean
struct Elliptic {
  explicit Elliptic(double m)
  {
    double a = 1, b = std::sqrt(1 - m), sum = m / 2, power = .5;
    while (std::abs(a - b) > 1e-15) {
      const double c = (a - b) / 2;
      power *= 2;
      sum += power * c * c;
      const double mean = (a + b) / 2;
      b = std::sqrt(a * b);
      a = mean;
    }
    K = pi / (2 * a);
    E = K * (1 - sum);
  }
  double K, E;
};

/// the parameter of the figure eight among the elastica: 2 E = K
double parameter_of_eight()
{
  double low = .5, high = .99;
  while (high - low > 1e-15) {
    const double m = (low + high) / 2;
    (2 * Elliptic(m).E > Elliptic(m).K ? low : high) = m;
  }
  return low;
}

TEST(Elliptic, integrals_and_figure_eight_are_those_of_the_tables)
{
  EXPECT_NEAR(Elliptic(.5).K, 1.854074677301372, 1e-14);
  EXPECT_NEAR(Elliptic(.5).E, 1.350643881047675, 1e-14);
  EXPECT_NEAR(parameter_of_eight(), .8261147660, 1e-10);
}

TEST(Shapes, are_those_of_the_reference)
{
  EXPECT_NEAR(length_of(flower(200)), 9.079093, 1e-6);
  EXPECT_NEAR(energy_times_length(flower(200)), 1035.633106, 1e-6);
  EXPECT_NEAR(energy_times_length(ellipse(200)), 117.170226, 1e-6);
  EXPECT_NEAR(energy_times_length(figure_eight(200)), 206.716378, 1e-6);
  EXPECT_NEAR(energy_times_length(limacon(200)), 220.014633, 1e-6);
  EXPECT_NEAR(energy_times_length(rose(200)), 382.494828, 1e-6);
}

TEST(Limits, curves_that_turn_become_circles)
{
  const auto limit = [](const Curve& c) { return energy_times_length(flown(c, .5, 20)); };
  EXPECT_NEAR(limit(flower(200)), 39.478418, 1e-5);
  EXPECT_NEAR(limit(ellipse(200)), 39.478418, 1e-5);
  EXPECT_NEAR(limit(limacon(200)), 157.913670, 1e-5);
  EXPECT_NEAR(limit(rose(200)), 355.305758, 1e-5);
}

TEST(Limits, curves_that_do_not_turn_become_the_eight_among_the_elastica)
{
  const double m = parameter_of_eight(), K = Elliptic(m).K;
  const double energy = 32 * K * K * (2 * m - 1);
  EXPECT_NEAR(energy, 112.439610, 1e-6);
  double defects[3];
  int i = 0;
  for (const int size : {100, 200, 400})
    defects[i++] = energy - energy_times_length(flown(figure_eight(size), .5, 20));
  EXPECT_NEAR(energy - defects[1], 112.4239, 5e-4);
  EXPECT_NEAR(std::log2(defects[0] / defects[1]), 2, 0.02);
  EXPECT_NEAR(std::log2(defects[1] / defects[2]), 2, 0.02);
}

// As in the reference, each step recomputes the lengths, and changes them.
Curve flown_with_current_lengths(Curve curve, double tau, int steps)
{
  for (int i = 0; i < steps; ++i) curve = flown(curve, tau, 1, least_squares);
  return curve;
}

// A figure eight run through several times has n^2 times the least energy, and is a saddle.
TEST(Limits, of_eights_run_through_several_times_is_the_eight_run_once)
{
  const double m = parameter_of_eight(), K = Elliptic(m).K, least = 32 * K * K * (2 * m - 1);
  for (const int times : {2, 3, 4})
    for (const int size : {200, 300}) {
      const Curve eight = sampled(size, [times](double t) {
        return std::complex(2 * std::sin(times * t), std::sin(2 * times * t));
      });
      CGP::Curve_flow_options options;
      options.max_steps = 400;
      CGP::Isometric_curve_flow flow(eight, options);
      CGP::Curve_flow_visitor silent;
      const CGP::Curve_flow_report report = flow.run(silent);
      EXPECT_TRUE(report) << times;
      EXPECT_NEAR(energy_times_length(flow.points()), least, .003 * least) << times << " " << size;
      EXPECT_LT(report.length_distortion, 1e-11);
    }
}

TEST(Limits, of_the_eight_with_current_lengths_are_those_of_the_reference)
{
  const auto limit = [](int m) {
    return energy_times_length(flown_with_current_lengths(figure_eight(m), .5, 20));
  };
  EXPECT_NEAR(limit(100), 112.3767, 2e-4);
  EXPECT_NEAR(limit(200), 112.4239, 5e-5);
  EXPECT_NEAR(limit(400), 112.4357, 5e-5);
  EXPECT_NEAR(limit(800), 112.4386, 5e-5);
}

TEST(Limits, largest_curvature_of_the_eight_is_that_of_its_elastica)
{
  const double m = parameter_of_eight(), K = Elliptic(m).K;
  const Curve eight = flown(figure_eight(400), .5, 20);
  EXPECT_NEAR(curvatures_of(eight).maxCoeff() * length_of(eight) / (8 * std::sqrt(m) * K), 1, 3e-3);
}

TEST(Energies, after_one_two_and_three_steps)
{
  const std::pair<Curve, std::vector<double>> cases[] = {
      {flower(200), {39.4785, 39.4784}},
      {ellipse(200), {39.4784}},
      {figure_eight(200), {112.8828, 112.4283, 112.4240}},
      {limacon(200), {164.0643, 157.9939, 157.9137}},
      {rose(200), {355.4055, 355.3058}}};
  for (const auto& [curve, expected] : cases) {
    Curve after = curve;
    for (const double energy : expected) {
      after = flown_with_current_lengths(after, .5, 1);
      EXPECT_NEAR(energy_times_length(after), energy, 6e-5);
    }
  }
}

TEST(Energies, are_within_a_thousandth_of_the_least_after_two_steps_with_exact_closing)
{
  const std::pair<Curve, double> cases[] = {{flower(200), 39.478418},
                                            {figure_eight(200), 112.4239},
                                            {limacon(200), 157.913670},
                                            {rose(200), 355.305758}};
  for (const auto& [curve, least] : cases)
    EXPECT_NEAR(energy_times_length(flown(curve, .5, 2)) / least, 1, 1e-3);
}

TEST(Length_distortion, of_one_step_without_exact_closing_is_of_second_order)
{
  const std::pair<Curve, std::vector<double>> cases[] = {
      {flower(200), {3.316e-3, 8.398e-4, 2.071e-4, 5.117e-5, 1.270e-5, 3.163e-6}},
      {figure_eight(200), {7.411e-3, 1.920e-3, 4.874e-4, 1.227e-4, 3.077e-5, 7.705e-6}},
      {limacon(200), {7.695e-2, 2.126e-2, 5.515e-3, 1.400e-3}}};
  for (const auto& [curve, expected] : cases) {
    double tau = .4, before = 0;
    for (const double value : expected) {
      const double measured = distortion(curve, flown(curve, tau, 1, least_squares));
      EXPECT_NEAR(measured / value, 1, 1e-3) << tau;
      if (before > 0) {
        EXPECT_NEAR(std::log2(before / measured), 2, 0.15) << tau;
      }
      before = measured;
      tau /= 2;
    }
  }
}

TEST(Length_distortion, is_that_of_the_points_that_are_written)
{
  for (const double offset : {0., 1e3, 1e6}) {
    Curve far = flower(200);
    far.colwise() += Eigen::Vector2d(offset, -2 * offset);
    CGP::Isometric_curve_flow flow(far);
    CGP::Curve_flow_visitor silent;
    const CGP::Curve_flow_report report = flow.run(silent);
    EXPECT_NEAR(report.length_distortion, distortion(far, flow.points()),
                .01 * report.length_distortion + 1e-14)
        << offset;
    EXPECT_LT(report.length_distortion, 1e-12 + 2e-14 * offset);
  }
}

TEST(Length_distortion, is_the_gap_that_the_report_tells)
{
  CGP::Curve_flow_options options;
  options.time_step = .1;
  options.closing = least_squares;
  CGP::Isometric_curve_flow flow(figure_eight(200), options);
  const CGP::Curve_step_report step = flow.step();
  EXPECT_EQ(step.first_gap, step.gap);
  EXPECT_NEAR(step.length_distortion / step.gap, 1, 1e-3);
  EXPECT_NEAR(step.length_distortion, distortion(figure_eight(200), flow.points()), 1e-14);
}

TEST(Length_distortion, vanishes_with_the_lengths_of_the_first_curve_in_every_step)
{
  const auto measured = [](const Curve& c) {
    return distortion(c, flown(c, .25, 30, least_squares));
  };
  EXPECT_LT(measured(flower(200)), 1e-11);
  EXPECT_LT(measured(figure_eight(200)), 2e-8);
  EXPECT_LT(measured(limacon(200)), 1e-9);
}

TEST(Length_distortion, adds_up_with_the_lengths_of_the_curve_before)
{
  const auto measured = [](const Curve& c) {
    return distortion(c, flown_with_current_lengths(c, .25, 30));
  };
  EXPECT_NEAR(measured(flower(200)), 1.6e-3, 1e-4);
  EXPECT_NEAR(measured(figure_eight(200)), 4.2e-3, 1e-4);
  EXPECT_NEAR(measured(limacon(200)), 5.9e-2, 1e-3);
}

}  // namespace cgp_test::isometric_curve_flow_limits_tests
