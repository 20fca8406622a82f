// Tests include/Conformal_geometry_processing/flow/Conformal_willmore_flow.h
// Tests include/Conformal_geometry_processing/flow/Class_keeper.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bounded_flows.h"
#include "support/random.h"

namespace cgp_test::flow_on_class_boundary_tests {

/// Laws of the flow on the exact discrete conformal class with a boundary.

using Flow = CGP::Conformal_willmore_flow;

struct Flown {
  Flown(const Mesh_view& mesh, const Boundary_condition& condition, bool is_exact, int steps = 20)
      : flow(mesh, options(condition, is_exact, steps)), report(flow.run())
  {}

  static CGP::Flow_options options(const Boundary_condition& condition, bool is_exact, int steps)
  {
    CGP::Flow_options options;
    options.surface.boundary = condition;
    options.surface.exact_conformal_class = is_exact;
    options.max_steps = steps;
    return options;
  }

  /// the mean angle between the first and the last directions of the boundary, in degrees
  double drift(const Boundary_condition& condition) const
  {
    const auto first = CGP::boundary_frames(flow.initial_mesh()),
               last = CGP::boundary_frames(flow.mesh());
    double sum = 0;
    for (std::size_t k = 0; k < first.frames.size(); ++k) {
      const Eigen::Vector3d a = first.frames[k] * condition.direction,
                            b = last.frames[k] * condition.direction;
      sum += std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / pi;
    }
    return sum / double(first.frames.size());
  }

  Flow flow;
  CGP::Flow_report report;
};

std::vector<Boundary_condition> conditions()
{
  return {Boundary_condition::free(), Boundary_condition::tangents(),
          Boundary_condition::binormals()};
}

/// what directions that are kept admit instead of a lower energy
bool falls_by_a_tenth(const CGP::Flow_step_report& step)
{
  return step.direction_norm_after > 0 && step.direction_norm_after < .9 * step.direction_norm;
}

TEST(Flow_on_class_with_boundary, keeps_length_cross_ratios_of_disks_and_rings)
{
  for (const Mesh_view& mesh : {bumpy_cap(8), bumpy_annulus(5), perturbed(bumpy_cap(8), .01)})
    for (const Boundary_condition& condition : conditions()) {
      const Flown run(mesh, condition, true, 5);
      EXPECT_LT(run.report.conformality.length_cross_ratio.max, 1e-10);
      EXPECT_LT(run.report.energy, .9 * run.report.initial_energy);
      for (const CGP::Flow_step_report& step : run.report.steps) {
        EXPECT_LE(step.length_cross_ratio, 1e-3);
        EXPECT_TRUE(step.energy < step.energy_before || falls_by_a_tenth(step))
            << step.energy - step.energy_before;
      }
    }
}

TEST(Flow_on_class_with_boundary, never_raises_the_energy_of_a_free_boundary)
{
  for (const Mesh_view& mesh : {bumpy_cap(8), bumpy_annulus(5), perturbed(bumpy_cap(8), .01)})
    for (const CGP::Flow_step_report& step :
         Flown(mesh, Boundary_condition::free(), true).report.steps)
      EXPECT_LT(step.energy, step.energy_before);
}

/// a ring about the z axis of height 2 that is as wide in the middle as the profile says, with
/// waves that leave its boundary and its binormals as they are
Mesh_view barrel(int m, double wave)
{
  return ring(m, m / 3, [&](double angle, double s) {
    const double bump = wave * std::sin(3 * angle + 1) * std::pow(4 * s * (1 - s), 2);
    const double r = 1 + .3 * std::sin(pi * s) + bump;
    return Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), 2 * s - 1);
  });
}

/// The first integral r dz/ds - H r^2 of a surface of revolution of constant mean curvature
/// [Delaunay 1841] at the circles of a barrel inside: its range. H is a half on a cylinder.
double range_of_first_integral(const Mesh_view& mesh, int m)
{
  const CGP::Points& f = mesh.positions();
  const int rows = static_cast<int>(f.cols()) / m;
  const auto place = [&](int row) {
    const Points circle = f.middleCols(row * m, m);
    const Eigen::Vector3d center = circle.rowwise().mean();
    return Eigen::Vector2d((circle.colwise() - center).colwise().norm().mean(), center.z());
  };
  const Eigen::VectorXd H = CGP::mean_curvature(mesh), areas = CGP::vertex_areas(mesh);
  const auto inside = Eigen::seqN(m, (rows - 2) * m);
  const double mean = areas(inside).dot(H(inside)) / areas(inside).sum();
  double least = HUGE_VAL, largest = -HUGE_VAL;
  for (int row = 1; row + 1 < rows; ++row) {
    const Eigen::Vector2d before = place(row - 1), here = place(row), after = place(row + 1);
    const Eigen::Vector2d t = ((after - here).normalized() + (here - before).normalized()) / 2;
    const double integral = here[0] * t[1] - mean * here[0] * here[0];
    least = (std::min)(least, integral), largest = (std::max)(largest, integral);
  }
  return largest - least;
}

TEST(Flow_on_class_with_boundary, ends_at_delaunay_surfaces_with_binormals)
{
  for (const double wave : {0., .15})
    for (const int m : {24, 48}) {
      const Mesh_view mesh = barrel(m, wave);
      const Flown run(mesh, Boundary_condition::binormals(), true, 40);
      EXPECT_TRUE(run.report.converged()) << run.report.message;
      EXPECT_LT(range_of_first_integral(run.flow.mesh(), m), .1 * range_of_first_integral(mesh, m));
      EXPECT_LT(run.report.direction_norm, 24. / (m * m) * std::sqrt(run.report.energy));
      EXPECT_LT(run.report.energy, 1.02 * run.report.initial_energy);
    }
}

// An inverted cylinder has the least energy of its class for these binormals, as the cylinder has.
TEST(Flow_on_class_with_boundary,
     tells_where_only_what_closes_a_ring_keeps_it_from_constant_curvature)
{
  const Mesh_view inverted = mapped(cylinder(1, 2, 48, 16), [](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = p - Eigen::Vector3d(.3, .1, 1);
    return Eigen::Vector3d(q / q.squaredNorm());
  });
  const Flown run(inverted, Boundary_condition::binormals(), true, 40);
  EXPECT_TRUE(run.report.converged()) << run.report.message;
  const Mesh_view& last = run.flow.mesh();
  const Eigen::VectorXd H = CGP::mean_curvature(last), areas = CGP::vertex_areas(last);
  const double mean = areas.dot(H) / areas.sum();
  const double deviation = std::sqrt(areas.dot((H.array() - mean).square().matrix()));
  EXPECT_GT(deviation, .1 * std::sqrt(run.report.energy));
  EXPECT_LT(run.report.direction_norm, .3 * deviation);
}

TEST(Flow_on_class_with_boundary, keeps_the_first_tangents_and_binormals)
{
  for (const Mesh_view& mesh : {bumpy_cap(12), bumpy_annulus(8)})
    for (const Boundary_condition& condition :
         {Boundary_condition::tangents(), Boundary_condition::binormals()}) {
      const double exact = Flown(mesh, condition, true).drift(condition),
                   plain = Flown(mesh, condition, false).drift(condition);
      EXPECT_LT(exact, .5);
      EXPECT_LT(exact, .4 * plain);
    }
}

TEST(Flow_on_class_with_boundary, tells_how_far_directions_are_from_the_first)
{
  for (const Boundary_condition& condition :
       {Boundary_condition::tangents(), Boundary_condition::binormals()})
    for (const int steps : {1, 4, 20}) {
      const Flown run(bumpy_annulus(5), condition, true, steps);
      const CGP::Spin_report& last = run.report.steps.back().spin;
      EXPECT_NEAR(last.direction_error.mean * 180 / pi, run.drift(condition), .01);
      EXPECT_GE(last.direction_error.max, last.direction_error.mean);
    }
}

TEST(Flow_on_class_with_boundary, comes_nearer_to_minimal_surfaces)
{
  for (const Mesh_view& mesh : {bumpy_cap(12), bumpy_annulus(8)})
    for (const Boundary_condition& condition :
         {Boundary_condition::free(), Boundary_condition::tangents()}) {
      const Flown exact(mesh, condition, true), plain(mesh, condition, false);
      EXPECT_LT(exact.report.energy, .95 * plain.report.energy);
      EXPECT_LT(exact.report.energy, .01 * exact.report.initial_energy);
    }
}

// The faces there are as noisy as the rest.
TEST(Flow_on_class_with_boundary, takes_noise_away_that_the_plain_flow_leaves)
{
  const Mesh_view mesh = perturbed(bumpy_cap(16), .01);
  for (const Boundary_condition& condition : conditions()) {
    const Flown exact(mesh, condition, true), plain(mesh, condition, false);
    EXPECT_LT(exact.report.energy, .6 * plain.report.energy);
    EXPECT_LT(exact.report.conformality.quasi_conformal.mean, 1.04);
    EXPECT_GT(plain.report.conformality.quasi_conformal.mean, 1.4);
  }
}

TEST(Flow_on_class_with_boundary, turns_a_hemisphere_to_prescribed_binormals)
{
  const Mesh_view hemisphere = cap_from_disk(disk(12), pi / 2);
  const auto frames = CGP::boundary_frames(hemisphere);
  Boundary_condition condition = Boundary_condition::binormals();
  condition.targets.resize(3, static_cast<Eigen::Index>(frames.frames.size()));
  for (std::size_t k = 0; k < frames.frames.size(); ++k) {
    const Eigen::Vector3d p = hemisphere.position(frames.vertices[k]);
    condition.targets.col(static_cast<Eigen::Index>(k)) =
        .5 * Eigen::Vector3d(p.x(), p.y(), 0).normalized() -
        std::sqrt(.75) * Eigen::Vector3d::UnitZ();
  }
  const Flown run(hemisphere, condition, true);
  EXPECT_TRUE(run.report.converged())
      << CGP::to_string(run.report.stop) << ' ' << run.report.message;
  EXPECT_LT(run.report.conformality.length_cross_ratio.max, 1e-10);
  EXPECT_NEAR(run.report.energy, pi, .08 * pi);
}

}  // namespace cgp_test::flow_on_class_boundary_tests
