// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "flow_tools.h"

namespace cgp_test::conformal_willmore_flow_stability_tests {

/// The bound 0 < tau < 2 of the time step, which is independent of the mesh.

/// the energies of the surface and of five more
std::vector<double> energies(const Mesh_view& mesh, double time_step)
{
  CGP::Conformal_willmore_flow flow(mesh, plain_steps(time_step, 5));
  std::vector<double> list = {flow.energy()};
  for (const auto& step : flow.run().steps) list.push_back(step.energy);
  EXPECT_EQ(list.size(), 6U);
  return list;
}

void expect_stable_up_to_two(const Mesh_view& mesh)
{
  const std::vector<double> small = energies(mesh, 1.4), large = energies(mesh, 2.6);
  EXPECT_TRUE(std::is_sorted(small.rbegin(), small.rend()));
  EXPECT_LT(small.back(), 1.02 * 4 * pi);
  EXPECT_TRUE(std::is_sorted(large.begin(), large.end()));
}

/// n random points of the unit sphere, however near to each other
Points random_points(int n)
{
  Random random(1);
  Points p(3, n);
  for (int v = 0; v < n; ++v) {
    Eigen::Vector3d point = random.vector();
    while (point.norm() > 1) point = random.vector();
    p.col(v) = point.normalized();
  }
  return p;
}

/// vertices of a bumpy sphere, triangulated as the convex hull of their projections to the round
/// one
Mesh_view bumpy_hull(int n)
{
  const Points sphere = random_points(n);
  return mapped({sphere, convex_hull(sphere)}, [](const Eigen::Vector3d& p) {
    const double x = p.x(), y = p.y(), z = p.z();
    const double bump = x * y + z * (5 * z * z - 3) / 4 + 0.4 * (x * x - y * y) * z;
    return Eigen::Vector3d((1 + 0.25 * bump) * p);
  });
}

double smallest_angle(const Mesh_view& mesh)
{
  double smallest = pi;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int c = 0; c < 3; ++c) smallest = std::min(smallest, CGP::corner_angle(mesh.sheet(f), c));
  return smallest;
}

TEST(Conformal_willmore_flow_stability, is_bounded_by_two_on_a_regular_sphere)
{
  expect_stable_up_to_two(bumpy_sphere(4));
}

TEST(Conformal_willmore_flow_stability, is_bounded_by_two_on_a_sphere_of_slivers)
{
  const Mesh_view mesh = bumpy_hull(2500);
  EXPECT_LT(smallest_angle(mesh), 0.3 * pi / 180);
  expect_stable_up_to_two(mesh);
}

TEST(Conformal_willmore_flow_stability, comes_from_backtracking_where_the_step_is_too_large)
{
  CGP::Flow_options options;
  options.time_step = 2.6;
  CGP::Conformal_willmore_flow flow(bumpy_sphere(3), options);
  const CGP::Flow_report report = flow.run();
  EXPECT_TRUE(report.converged()) << to_string(report.stop);
  EXPECT_LT(report.energy, 1.0005 * CGP::willmore_energy(icosphere(3)));
  double energy = report.initial_energy;
  for (const auto& step : report.steps) {
    EXPECT_LT(step.energy, energy);
    energy = step.energy;
  }
}

TEST(Conformal_willmore_flow_stability, lets_noise_decay_slower_than_shapes)
{
  // A curvature potential is averaged twice, which suppresses frequencies of the mesh size.
  const Mesh_view sphere = icosphere(3), noisy = radially_perturbed(sphere, 0.002);
  CGP::Conformal_willmore_flow flow(noisy, plain_steps(1, 1));
  const double before = flow.energy() - CGP::willmore_energy(sphere);
  ASSERT_TRUE(flow.step().accepted);
  const double after = flow.energy() - CGP::willmore_energy(sphere);
  EXPECT_GT(after, 0.1 * before);
  EXPECT_LT(after, 0.9 * before);
}

}  // namespace cgp_test::conformal_willmore_flow_stability_tests
