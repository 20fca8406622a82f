// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "flow_tools.h"

/// Laws of the flow on spheres. The energies of the reference runs come from an implementation of
/// the same formulas that shares no code with this one.
namespace {

using namespace cgp_test;

/// amplitude of the surface's radius along the zonal harmonic of degree k, by the mean radius
double amplitude(const Mesh_view& sphere, const Mesh_view& mesh, int k)
{
  const Eigen::VectorXd areas = CGP::vertex_areas(sphere);
  double product = 0, square = 0, sum = 0;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const double Y = legendre(k, sphere.position(v).z()), r = mesh.position(v).norm();
    product += areas[v] * Y * r;
    square += areas[v] * Y * Y;
    sum += areas[v] * r;
  }
  return product / square / (sum / areas.sum());
}

/// of the largest wavelength's Laplacian, 1 - 2 / (k (k + 1))
double damping(int k)
{
  return 1 - 2. / (k * (k + 1));
}

void expect_energies(double time_step, const std::vector<double>& expected)
{
  CGP::Conformal_willmore_flow<> flow(scaled_to_area(bumpy_sphere(4), 4 * pi),
                                      plain_steps(time_step, static_cast<int>(expected.size())));
  const CGP::Flow_report report = flow.run();
  ASSERT_EQ(report.steps.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(report.steps[i].energy, expected[i], 1e-4 * expected[i]);
}

}  // namespace

TEST(Conformal_willmore_flow, keeps_the_round_sphere)
{
  CGP::Conformal_willmore_flow<> flow(icosphere(4), plain_steps(1, 5));
  EXPECT_EQ(flow.run().steps.size(), 5U);
  EXPECT_LT(radius_deviation(flow.mesh()), 1e-6);
}

TEST(Conformal_willmore_flow, knows_that_nothing_is_left_to_do_on_the_round_sphere)
{
  CGP::Conformal_willmore_flow<> flow(icosphere(4));
  const CGP::Flow_report report = flow.run();
  EXPECT_EQ(report.stop, CGP::Flow_stop::direction_vanished);
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
    const double before = amplitude(sphere, bumped, k);
    for (const double tau : {0.5, 1., 1.5}) {
      CGP::Conformal_willmore_flow<> flow(bumped, plain_steps(tau, 1));
      ASSERT_TRUE(flow.step().accepted);
      const double factor = amplitude(sphere, flow.mesh(), k) / before;
      EXPECT_NEAR((1 - factor) / (tau * damping(k)), 1, 0.05) << k << ' ' << tau;
    }
  }
}

TEST(Conformal_willmore_flow, has_the_energies_of_the_reference_runs)
{
  expect_energies(1, {12.616282143447915, 12.556445270377099, 12.551874, 12.551432, 12.551384});
  expect_energies(0.5, {13.009069749393657, 12.72403198216271, 12.617591164018625});
  expect_energies(2.6, {13.945916367456661, 14.153799338979535, 14.57166165351061});
}

TEST(Conformal_willmore_flow, reaches_the_sphere_in_three_steps)
{
  const double limit = CGP::willmore_energy(icosphere(4));
  CGP::Conformal_willmore_flow<> flow(bumpy_sphere(4));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(flow.step().accepted);
  EXPECT_LT(flow.energy(), 1.0005 * limit);
  const CGP::Flow_report rest = flow.run();
  EXPECT_TRUE(rest.converged());
  EXPECT_LT(radius_deviation(flow.mesh()), 0.002);
  EXPECT_LT(rest.conformality.quasi_conformal.mean, 1.01);
  EXPECT_EQ(rest.conformality.flipped_faces, 0);
}

TEST(Conformal_willmore_flow, keeps_area_and_centroid)
{
  const Eigen::Vector3d offset(3, -2, 5);
  const Mesh_view mesh = mapped(
      bumpy_sphere(3), [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(2 * p + offset); });
  CGP::Conformal_willmore_flow<> flow(mesh);
  EXPECT_TRUE(flow.run());
  EXPECT_NEAR(area(flow.mesh()), area(mesh), 1e-9 * area(mesh));
  EXPECT_LT((centroid(flow.mesh()) - centroid(mesh)).norm(), 1e-9);
}

TEST(Conformal_willmore_flow, reports_what_it_did)
{
  const Mesh_view mesh = bumpy_sphere(3);
  CGP::Conformal_willmore_flow<> flow(mesh);
  EXPECT_EQ(flow.energy(), CGP::willmore_energy(mesh));
  const CGP::Flow_report report = flow.run();
  EXPECT_EQ(flow.size_of_steps(), static_cast<int>(report.steps.size()));
  EXPECT_EQ(flow.initial_mesh().positions(), mesh.positions());
  EXPECT_EQ(report.initial_energy, CGP::willmore_energy(mesh));
  EXPECT_EQ(report.energy, CGP::willmore_energy(flow.mesh()));
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
