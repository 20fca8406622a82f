// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "bounded_flows.h"

namespace cgp_test::conformal_willmore_flow_boundary_turned_tests {

/// Surfaces of constant mean curvature with prescribed directions at the boundary.

/// a direction for each vertex of the boundary, from its angle around the axis and its frame
template <class Direction>
Points directions(const Mesh_view& mesh, Direction direction)
{
  const CGP::internal::Boundary_frames b = CGP::boundary_frames(mesh);
  Points targets(3, static_cast<Eigen::Index>(b.vertices.size()));
  for (std::size_t k = 0; k < b.vertices.size(); ++k) {
    const Eigen::Vector3d p = mesh.position(b.vertices[k]);
    targets.col(static_cast<Eigen::Index>(k)) = direction(std::atan2(p.y(), p.x()), b.frames[k]);
  }
  return targets;
}

/// binormals of the spherical cap of polar angle `tilt`
Boundary_condition tilted(const Mesh_view& hemisphere, double tilt)
{
  return Boundary_condition::binormals(
      directions(hemisphere, [=](double t, const CGP::internal::Boundary_frame&) {
        return Eigen::Vector3d(std::cos(tilt) * std::cos(t), std::cos(tilt) * std::sin(t),
                               -std::sin(tilt));
      }));
}

/// binormals turned about the tangents by amplitude * cos(3 t)
Boundary_condition oscillating(const Mesh_view& mesh, double amplitude)
{
  return Boundary_condition::binormals(
      directions(mesh, [=](double t, const CGP::internal::Boundary_frame& frame) {
        const double a = amplitude * std::cos(3 * t);
        return Eigen::Vector3d(std::cos(a) * frame.col(2) + std::sin(a) * frame.col(1));
      }));
}

/// H at the vertices inside, weighted by area
struct Mean_curvature {
  double mean = 0;       ///< times the root of the area
  double deviation = 0;  ///< relative to the mean
};

Mean_curvature mean_curvature_of(const Mesh_view& mesh, const Eigen::VectorXd& H)
{
  const Eigen::VectorXd A = CGP::vertex_areas(mesh);
  const std::vector<char> is_boundary = CGP::boundary_vertices(mesh);
  double total = 0, sum = 0, squares = 0;
  for (int v = 0; v < H.size(); ++v)
    if (!is_boundary[at(v)]) total += A[v], sum += A[v] * H[v], squares += A[v] * H[v] * H[v];
  const double mean = sum / total;
  return {mean * std::sqrt(area(mesh)), std::sqrt(squares / total - mean * mean) / mean};
}

struct Reference_flow : CGP::Conformal_willmore_flow {
  Reference_flow(const Mesh_view& mesh, const CGP::Flow_options& options)
      : Conformal_willmore_flow(mesh, options, Barycentric_direction())
  {}
};

Mesh_view hemisphere(int n)
{
  return cap_from_disk(disk(n), pi / 2);
}

/// expects `mean * sqrt(area)` of the reference runs after so many steps of tau = 1
CGP::Flow_report expect_reference(const Mesh_view& mesh, const Boundary_condition& condition,
                                  int steps, double mean, double deviation)
{
  Reference_flow flow(mesh, plain_steps(1, steps, condition));
  CGP::Flow_report report = flow.run();
  EXPECT_EQ(report.stop, CGP::Flow_step_report::Stop::steps_done) << report.message;
  const Mean_curvature H = mean_curvature_of(flow.mesh(), barycentric_mean_curvature(flow.mesh()));
  EXPECT_NEAR(H.mean, mean, 1e-4 * mean);
  EXPECT_LT(H.deviation, 1.05 * deviation);
  EXPECT_GT(report.steps.front().spin.overlap, .9);
  return report;
}

TEST(Conformal_willmore_flow_with_turned_boundary, turns_a_hemisphere_into_a_cap)
{
  const double exact = std::sqrt(pi);  // H = 1 / r, A = 2 pi (1 - cos(pi/3)) r^2
  std::vector<double> sizes, errors;
  const double expected[] = {1.84923, 1.81091}, deviations[] = {4.1e-3, 2.2e-3};
  for (const int i : {0, 1}) {
    const int n = 8 << i;
    const CGP::Flow_report report = expect_reference(hemisphere(n), tilted(hemisphere(n), pi / 3),
                                                     10, expected[i], deviations[i]);
    EXPECT_LT(report.steps.back().spin.direction_error.mean, .007 * pi / 180);
    sizes.push_back(1. / n);
    errors.push_back(expected[i] - exact);
  }
  EXPECT_NEAR(slope(sizes, errors), 1, .1);
}

TEST(Conformal_willmore_flow_with_turned_boundary, deviates_from_constant_curvature_by_a_thousandth)
{
  // Mixed Voronoi areas, the default, do ten times better than the barycentric ones of the
  // reference.
  const Mesh_view mesh = hemisphere(32);
  CGP::Conformal_willmore_flow flow(mesh, plain_steps(1, 6, tilted(mesh, pi / 3)));
  EXPECT_TRUE(flow.run());
  const Mean_curvature H = mean_curvature_of(flow.mesh(), CGP::mean_curvature(flow.mesh()));
  EXPECT_LT(H.deviation, 1.1e-3 / 5);
  EXPECT_NEAR(H.mean, std::sqrt(pi), .02);
}

TEST(Conformal_willmore_flow_with_turned_boundary, turns_a_hemisphere_into_most_of_a_sphere)
{
  (void)expect_reference(hemisphere(8), tilted(hemisphere(8), 2 * pi / 3), 10, 3.07817, 1.5e-2);
  (void)expect_reference(hemisphere(16), tilted(hemisphere(16), 2 * pi / 3), 10, 3.08385, 6.4e-3);
}

TEST(Conformal_willmore_flow_with_turned_boundary, follows_oscillating_binormals)
{
  const Mesh_view mesh = hemisphere(16);
  const CGP::Flow_report report =
      expect_reference(mesh, oscillating(mesh, .5), 24, 2.47960, 2.6e-3);
  EXPECT_NEAR(report.conformality.quasi_conformal.mean, 1.01214, 1e-5);
  const Mesh_view cap = cap_from_disk(disk(16), pi / 3);
  const CGP::Flow_report other = expect_reference(cap, oscillating(cap, .4), 10, 1.75499, 2.2e-3);
  EXPECT_NEAR(other.conformality.quasi_conformal.mean, 1.00833, 1e-5);
}

TEST(Conformal_willmore_flow_with_turned_boundary, takes_the_branch_that_turns_least)
{
  // The smallest singular value belongs to another surface: with its energy, 6.329.
  const Mesh_view mesh = hemisphere(32);
  Reference_flow flow(mesh, plain_steps(1, 6, oscillating(mesh, .5)));
  EXPECT_TRUE(flow.run());
  EXPECT_NEAR(flow.energy(), 6.14317, 2e-3);
}

TEST(Conformal_willmore_flow_with_turned_boundary, starts_though_there_is_nothing_to_smooth)
{
  const Mesh_view mesh = hemisphere(12);
  CGP::Flow_options options;
  for (const double tilt : {pi / 3, 2 * pi / 3}) {  // the energy of the second rises
    options.surface.boundary = tilted(mesh, tilt);
    CGP::Conformal_willmore_flow flow(mesh, options);
    const CGP::Flow_report report = flow.run();
    EXPECT_TRUE(report.converged()) << to_string(report.stop) << " " << report.message;
    EXPECT_LT(report.steps.size(), 15U);
    EXPECT_NEAR(report.energy, 2 * pi * (1 - std::cos(tilt)), .08 * report.energy);
    EXPECT_LT(report.steps.back().spin.direction_error.mean, 1e-2);
  }
}

TEST(Conformal_willmore_flow_with_turned_boundary, refuses_a_boundary_that_no_surface_has)
{
  const Mesh_view mesh = disk(16);
  for (const bool backtracking : {true, false}) {
    CGP::Flow_options options;
    options.backtracking = backtracking;
    options.surface.boundary = Boundary_condition::tangents(directions(
        mesh,
        [](double, const CGP::internal::Boundary_frame&) { return Eigen::Vector3d(1, 0, 0); }));
    CGP::Conformal_willmore_flow flow(mesh, options);
    const CGP::Flow_report report = flow.run();
    EXPECT_FALSE(report);
    EXPECT_EQ(report.message, to_string(CGP::Spin_report::Boundary_fault::not_realizable));
    EXPECT_EQ(flow.mesh().positions(), mesh.positions());
  }
}

}  // namespace cgp_test::conformal_willmore_flow_boundary_turned_tests
