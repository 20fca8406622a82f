// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/measure/distortion.h>

#include <gtest/gtest.h>
#include <Eigen/Core>

#include "flow_tools.h"
#include "quaternionic_linear_algebra/threads/threads.h"
#include "support/decompositions.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cgp_test::conformal_willmore_flow_tests {

namespace CGP = Conformal_geometry_processing;
using Boundary_fault = CGP::Spin_report::Boundary_fault;

class A_step : public testing::Test {
 protected:
  bool is_good() const { return CGP::step_fault(report, is_turning, is_exact, options).empty(); }

  CGP::Flow_options options;
  bool is_turning = false, is_exact = false;
  CGP::Spin_report report = [] {
    CGP::Spin_report good;
    good.converged = true;
    good.conformality.quasi_conformal.mean = 1;
    return good;
  }();
};

TEST_F(A_step, whose_equation_is_solved_may_be_taken)
{
  EXPECT_TRUE(is_good());
  report.converged = false;
  EXPECT_EQ(CGP::step_fault(report, false, false, options), "the Dirac equation is not solved");
  options.backtracking = false;
  EXPECT_FALSE(is_good());
}

TEST_F(A_step, that_distorts_is_not_taken_where_a_smaller_one_can_be)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {1.5, nan}) {
    report.conformality.quasi_conformal.mean = bad;
    options.backtracking = true;
    EXPECT_NE(CGP::step_fault(report, false, false, options).find("quasi-conformal"),
              std::string::npos);
    options.backtracking = false;
    EXPECT_TRUE(is_good());
  }
}

TEST_F(A_step, from_which_the_exact_class_is_to_be_reached_distorts_little)
{
  report.conformality.quasi_conformal.mean = 1.3;
  EXPECT_TRUE(is_good());
  is_exact = true;
  EXPECT_FALSE(is_good());
  options.max_step_distortion = 1.4;
  EXPECT_TRUE(is_good());
}

TEST_F(A_step, that_tears_is_not_taken_where_a_smaller_one_can_be)
{
  report.closure_residual = .9 * options.max_step_closure;
  EXPECT_TRUE(is_good());
  report.closure_residual = options.max_step_closure;
  EXPECT_NE(CGP::step_fault(report, false, false, options).find("closure"), std::string::npos);
  options.backtracking = false;
  EXPECT_TRUE(is_good());
}

TEST_F(A_step, to_directions_that_no_surface_has_is_not_taken_but_keeping_directions_is)
{
  report.boundary_fault = Boundary_fault::not_realizable;
  EXPECT_TRUE(is_good());
  is_turning = true;
  EXPECT_EQ(CGP::step_fault(report, true, false, options),
            CGP::to_string(Boundary_fault::not_realizable));
}

/// Laws of the flow on spheres. The energies of the reference runs come from an implementation of
/// the same formulas that shares no code with this one.

/// the parts of the surface's radius along the zonal harmonics of these degrees, of which the first
/// is zero, by the mean radius. Least squares, for on an icosphere they are not orthogonal.
Eigen::VectorXd amplitudes(const Mesh_view& sphere, const Mesh_view& mesh,
                           const std::vector<int>& degrees)
{
  Eigen::MatrixXd Y(mesh.size_of_vertices(), static_cast<Eigen::Index>(degrees.size()));
  for (Eigen::Index i = 0; i < Y.cols(); ++i)
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      Y(v, i) = legendre(degrees[static_cast<std::size_t>(i)], sphere.position(v).normalized().z());
  const Eigen::MatrixXd AY = CGP::vertex_areas(sphere).asDiagonal() * Y;
  const Eigen::VectorXd radius = mesh.positions().colwise().norm().transpose();
  const Eigen::VectorXd a = definite_solution(AY.transpose() * Y, AY.transpose() * radius);
  return a / a[0];
}

/// of the largest wavelength's Laplacian, 1 - 2 / (k (k + 1))
double damping(int k)
{
  return 1 - 2. / (k * (k + 1));
}

/// of the surface of the reference runs
CGP::Flow_report report_of_steps(double time_step, std::size_t steps)
{
  CGP::Conformal_willmore_flow flow(scaled_to_area(bumpy_sphere(4), 4 * pi),
                                    plain_steps(time_step, static_cast<int>(steps)));
  return flow.run();
}

void expect_energies(double time_step, const std::vector<double>& expected)
{
  // The reference solves X(rho), the library X(rho + gamma): they differ by the discretisation
  // error, which grows with the steps.
  const double tolerance = 1e-3;
  const CGP::Flow_report report = report_of_steps(time_step, expected.size());
  EXPECT_NEAR(report.initial_energy, 13.7916855636, 1e-9);
  ASSERT_EQ(report.steps.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(report.steps[i].energy, expected[i], tolerance * expected[i]) << i;
}

TEST(Conformal_willmore_flow, keeps_the_round_sphere)
{
  CGP::Conformal_willmore_flow flow(icosphere(4), plain_steps(1, 5));
  EXPECT_EQ(flow.run().steps.size(), 5U);
  EXPECT_LT(radius_deviation(flow.mesh()), 1e-6);
}

TEST(Conformal_willmore_flow, knows_that_nothing_is_left_to_do_on_the_round_sphere)
{
  CGP::Conformal_willmore_flow flow(icosphere(4));
  const CGP::Flow_report report = flow.run();
  EXPECT_EQ(report.stop, CGP::Flow_step_report::Stop::direction_vanished);
  EXPECT_TRUE(report.converged());
  EXPECT_TRUE(report.steps.empty());
  EXPECT_EQ(flow.mesh().positions(), icosphere(4).positions());
}

TEST(Conformal_willmore_flow, damps_each_frequency_as_linear_theory_says)
{
  const Mesh_view sphere = icosphere(4);
  for (const int k : {2, 3, 4}) {
    const Mesh_view bumped = mapped(sphere, [&](const Eigen::Vector3d& p) {
      return Eigen::Vector3d((1 + 0.02 / k * legendre(k, p.z())) * p);
    });
    const double before = amplitudes(sphere, bumped, {0, k})[1];
    for (const double tau : {0.5, 1., 1.5}) {
      CGP::Conformal_willmore_flow flow(bumped, plain_steps(tau, 1));
      ASSERT_TRUE(flow.step().accepted);
      const double factor = amplitudes(sphere, flow.mesh(), {0, k})[1] / before;
      EXPECT_NEAR((1 - factor) / (tau * damping(k)), 1, 0.05) << k << ' ' << tau;
    }
  }
}

TEST(Conformal_willmore_flow, has_the_energies_of_the_reference_runs)
{
  expect_energies(1, {12.616282, 12.556445, 12.551874, 12.551432, 12.551384, 12.551379});
  expect_energies(.5, {13.009070, 12.724032, 12.617591, 12.577165, 12.561577, 12.555475});
  expect_energies(2.6, {13.945916, 14.153799, 14.571662, 15.016047, 15.715396, 16.442925});
}

TEST(Conformal_willmore_flow, has_the_distortion_of_the_reference_run)
{
  const CGP::Flow_report report = report_of_steps(1, 6);
  ASSERT_EQ(report.steps.size(), 6U);
  const CGP::internal::Distribution& first = report.steps.front().quasi_conformal;
  const CGP::internal::Distribution& last = report.steps.back().quasi_conformal;
  EXPECT_NEAR(first.mean, 1.00731, 1e-5);
  EXPECT_NEAR(first.max, 1.0129, 1e-4);
  EXPECT_NEAR(last.mean, 1.00979, 1e-5);
  EXPECT_NEAR(last.max, 1.0173, 1e-4);
}

TEST(Conformal_willmore_flow, reaches_the_sphere_in_three_steps)
{
  const double limit = CGP::willmore_energy(icosphere(4));
  CGP::Flow_options options;
  options.surface.exact_conformal_class = false;
  CGP::Conformal_willmore_flow flow(bumpy_sphere(4), options);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(flow.step().accepted);
  EXPECT_LT(flow.energy(), 1.0005 * limit);
  const CGP::Flow_report rest = flow.run();
  EXPECT_TRUE(rest.converged());
  EXPECT_LT(radius_deviation(flow.mesh()), 0.002);
  EXPECT_LT(rest.conformality.quasi_conformal.mean, 1.01);
  EXPECT_EQ(rest.conformality.flipped_faces, 0);
}

TEST(Conformal_willmore_flow, keeps_what_its_filter_keeps)
{
  // A large wave and a small one: what four steps leave of them with filters of order 0 to 3.
  const Mesh_view sphere = scaled_to_area(icosphere(4), 4 * pi);
  const Mesh_view bumped = mapped(sphere, [&](const Eigen::Vector3d& p) {
    const double z = p.normalized().z();
    return Eigen::Vector3d((1 + .02 * legendre(2, z) + .001 * legendre(10, z)) * p);
  });
  const double large[] = {.201, .627, .901, .977}, small[] = {.1, .007, 0, 0};
  for (int k = 0; k <= 3; ++k) {
    CGP::Flow_options options = plain_steps(1, 4);
    options.filter_weight = std::pow(30., -k);
    options.filter_order = k;
    CGP::Conformal_willmore_flow flow(bumped, options);
    EXPECT_TRUE(flow.run());
    const Eigen::VectorXd left = amplitudes(sphere, flow.mesh(), {0, 2, 10});
    EXPECT_NEAR(left[1] / .02, large[k], .01) << k;
    EXPECT_NEAR(left[2] / .001, small[k], .05) << k;
  }
}

TEST(Conformal_willmore_flow, keeps_area_and_centroid)
{
  const Eigen::Vector3d offset(3, -2, 5);
  const Mesh_view mesh = mapped(
      bumpy_sphere(3), [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(2 * p + offset); });
  CGP::Conformal_willmore_flow flow(mesh);
  EXPECT_TRUE(flow.run());
  EXPECT_NEAR(area(flow.mesh()), area(mesh), 1e-9 * area(mesh));
  EXPECT_LT((centroid(flow.mesh()) - centroid(mesh)).norm(), 1e-9);
}

TEST(Conformal_willmore_flow, reports_what_it_did)
{
  const Mesh_view mesh = bumpy_sphere(3);
  CGP::Flow_options options;
  options.surface.exact_conformal_class = false;
  CGP::Conformal_willmore_flow flow(mesh, options);
  EXPECT_EQ(flow.energy(), CGP::willmore_energy(mesh));
  const CGP::Flow_report report = flow.run();
  EXPECT_EQ(flow.size_of_steps(), static_cast<int>(report.steps.size()));
  EXPECT_EQ(flow.initial_mesh().positions(), mesh.positions());
  EXPECT_EQ(report.initial_energy, CGP::willmore_energy(mesh));
  EXPECT_NEAR(report.energy, CGP::willmore_energy(flow.mesh()), 1e-13 * report.energy);
  double energy = report.initial_energy;
  for (std::size_t i = 0; i < report.steps.size(); ++i) {
    const CGP::Flow_step_report& step = report.steps[i];
    EXPECT_EQ(step.step, static_cast<int>(i) + 1);
    EXPECT_EQ(step.energy_before, energy);
    EXPECT_LT(step.energy, energy);
    EXPECT_EQ(step.time_step, 1);
    EXPECT_EQ(step.trials, 1);
    EXPECT_TRUE(step.spin.converged);
    EXPECT_LT(step.spin.closure_residual, 2e-3);
    EXPECT_GT(step.seconds, 0);
    energy = step.energy;
  }
  const auto total = CGP::quasi_conformal_error(mesh, flow.mesh().positions());
  EXPECT_EQ(report.steps.back().quasi_conformal.mean, total.mean);
  EXPECT_EQ(report.conformality.quasi_conformal.max, total.max);
}

TEST(Conformal_willmore_flow, gives_the_same_bits_again_and_with_two_threads)
{
  const auto positions = [](int threads) {
    const Threads setting(threads);
    CGP::Conformal_willmore_flow flow(bumpy_sphere(4), plain_steps(1, 2));
    EXPECT_GT(flow.run().steps.size(), 0u);
    return Points(flow.mesh().positions());
  };
  const Points one = positions(1);
  for (const int threads : {1, 2}) EXPECT_EQ(positions(threads), one) << threads;
}

}  // namespace cgp_test::conformal_willmore_flow_tests
