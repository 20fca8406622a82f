// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/flow/Scale_bound.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "flow_tools.h"
#include "support/random.h"
#include "support/spheres.h"

namespace cgp_test::scale_bound_tests {

using CGP::Spin_result;
using CGP::internal::Scale_bound;
using CGP::internal::vertex_log_scales;

/// a sphere with a waist, whose ends differ in size
Mesh_view dumbbell(const Mesh_view& sphere, double neck)
{
  return mapped(sphere, [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d q = p.normalized();
    const double waist = neck + (1 - neck) * std::pow((q.z() - .2) / .8, 2);
    return Eigen::Vector3d(waist * q.x(), 1.1 * waist * q.y(), 1.5 * q.z());
  });
}

/// x / |x - c|^2 about a point inside: lengths l become l / (|x - c| |y - c|)
TEST(Scale_bound, has_the_logarithms_of_a_moebius_transform)
{
  const Mesh_view mesh = perturbed(bumpy_sphere(2), .1);
  const Eigen::Vector3d c(.2, .1, -.3);
  Points f = mesh.positions().colwise() - c;
  Eigen::VectorXd expected(f.cols());
  for (Eigen::Index v = 0; v < f.cols(); ++v) {
    expected[v] = -2 * std::log(f.col(v).norm());
    f.col(v) /= f.col(v).squaredNorm();
  }
  EXPECT_LT((vertex_log_scales(mesh, f) - expected).cwiseAbs().maxCoeff(), 1e-12);
}

/// a sphere turned inside out about a point that is not its centre
Mesh_view inverted(const Mesh_view& mesh)
{
  Mesh_view inverted = mesh;
  Points f = mesh.positions();
  f.colwise() -= Eigen::Vector3d(0, 0, 1.5);
  f.array().rowwise() /= f.colwise().squaredNorm().array();
  inverted.set_positions(f);
  return inverted;
}

// What is small now counts by its size in the beginning.
TEST(Scale_bound, asks_the_next_surface_for_what_is_left)
{
  const Mesh_view mesh = bumpy_sphere(2), small = inverted(mesh);
  const Eigen::VectorXd u = vertex_log_scales(mesh, small.positions());
  const Eigen::VectorXd before = CGP::vertex_areas(mesh), now = CGP::vertex_areas(small);
  const CGP::Quaternion_vector<double> unmoved =
      CGP::Quaternion_vector<double>::Constant(u.size(), {1, 0, 0, 0});
  const Scale_bound bound(mesh, 3);
  const double used = bound.measured(small.positions()).excess();
  for (const double retreat : {0., .1}) {
    const CGP::internal::Scale_control control = bound.control(small, retreat);
    EXPECT_LT((control.factors.array().log() + u.array()).abs().maxCoeff(), 1e-12);
    EXPECT_LT((control.weights.cwiseProduct(now) - before).cwiseAbs().maxCoeff(), 1e-12);
    const double there = CGP::internal::measured_scales(unmoved, now, control).excess();
    EXPECT_NEAR((1 - there) * std::log(*control.bound), (1 - used - retreat) * std::log(3.), 1e-12);
  }
  const double growth = (2 * u.array()).exp().matrix().dot(before) / before.sum();
  EXPECT_NEAR(bound.measured(small.positions()).max, std::exp(u.maxCoeff()) / std::sqrt(growth),
              1e-12);
}

/// 1 % and 99 % of the scales of faces, by the area before, of a surface of unchanged area
std::pair<double, double> range(const Mesh_view& before, const Points& after)
{
  const Eigen::VectorXd u = CGP::length_scales(before, after).array().log();
  const Eigen::VectorXd areas = CGP::face_areas(before);
  return {std::exp(-CGP::internal::weighted_quantile(-u, areas, .99)),
          std::exp(CGP::internal::weighted_quantile(u, areas, .99))};
}

struct End {
  CGP::Flow_report report;
  Points positions;
};

End flown(const Mesh_view& mesh, std::optional<double> bound, int steps = 12)
{
  CGP::Flow_options options;
  options.max_steps = steps;
  options.surface.scales.bound = bound;
  CGP::Conformal_willmore_flow flow(mesh, options);
  CGP::Flow_report report = flow.run();
  return {std::move(report), flow.positions()};
}

TEST(Scale_bound, keeps_a_flow_within_it_and_costs_energy)
{
  for (const Mesh_view& sphere : {icosphere(2), icosphere(3), perturbed(icosphere(3), .06)}) {
    const Mesh_view mesh = dumbbell(sphere, .3);
    double last = flown(mesh, std::nullopt).report.energy;
    for (const double bound : {2.5, 1.6}) {
      const End end = flown(mesh, bound);
      EXPECT_TRUE(end.report) << end.report.message;
      EXPECT_LE(end.report.scales.excess(), 1 + 1e-9);
      EXPECT_GT(end.report.bounded_steps, 0);
      const auto [low, high] = range(mesh, end.positions);
      EXPECT_GT(low, .97 / bound);
      EXPECT_LT(high, 1.03 * bound);
      EXPECT_LT(end.report.energy, end.report.initial_energy);
      EXPECT_GT(end.report.energy, last - 1e-6);  // the tighter the more is left
      last = end.report.energy;
      for (const CGP::Flow_step_report& step : end.report.steps)
        EXPECT_LT(step.energy, step.energy_before);
    }
  }
}

/// the surface of a flow that has used all of its bound
struct At_bound {
  explicit At_bound(const Mesh_view& sphere, int steps = 4)
      : mesh(dumbbell(sphere, .3)), moved(mesh)
  {
    moved.set_positions(flown(mesh, 2, steps).positions);
    used = std::exp(std::log(2.) * Scale_bound(mesh, 2).measured(moved.positions()).excess());
  }

  /// of the present steps, tau (-H) without its mean, which has no effect
  std::optional<Spin_result> step(Scale_bound& bound, double tau) const
  {
    CGP::Spin_transformation transformation(moved);
    const Eigen::VectorXd H = CGP::mean_curvature(moved), areas = CGP::vertex_areas(moved);
    const Eigen::VectorXd rho = tau * (areas.dot(H) / areas.sum() - H.array());
    return bound.step(transformation, moved, rho, tau, [](const auto&) { return true; });
  }

  Mesh_view mesh, moved;
  double used = 0;
};

// Otherwise the energy would rise by as much in the smallest step, and the flow end: the nearest
// rho' is one of descent, whether lengths may still change or not.
TEST(Scale_bound, has_steps_that_tend_to_none_and_lower_the_energy)
{
  const std::vector<double> times{.02, .004, .0008};
  for (const Mesh_view& sphere : {icosphere(3), perturbed(icosphere(3), .06), icosphere(4)}) {
    const At_bound at(sphere);
    const double before = CGP::willmore_energy(at.moved);
    std::vector<double> changes, gains;
    for (const double tau : times) {
      Scale_bound bound(at.mesh, at.used);
      Mesh_view next = at.moved;
      next.set_positions(at.step(bound, tau)->positions);
      const Eigen::VectorXd u = vertex_log_scales(at.moved, next.positions());
      changes.push_back((u.array() - u.mean()).abs().mean());
      gains.push_back(before - CGP::willmore_energy(next));
      EXPECT_GT(gains.back(), 0) << tau;
    }
    EXPECT_GT(slope(times, changes), .85);
    EXPECT_NEAR(slope(times, gains), 1, .15);
  }
}

// Limbs that have to be larger again, by a rho so small, move against it.
TEST(Scale_bound, has_no_step_that_leads_back_against_rho)
{
  const At_bound at(icosphere(3));
  const double tau = .02;
  for (const double back : {0., .1, .4}) {
    Scale_bound bound(at.mesh, at.used);
    bound.set_pace({bound.pace().weight, back / tau});
    EXPECT_EQ(at.step(bound, tau).has_value(), back == 0) << back;
  }
}

// What edges leave open moves lengths beyond the bound; the next step makes room for it.
TEST(Scale_bound, learns_what_steps_miss_it_by)
{
  const At_bound at(icosphere(4), 3);
  for (const double tau : {.5, .1}) {
    Scale_bound bound(at.mesh, at.used);
    const auto excess = [&] { return bound.measured(at.step(bound, tau)->positions).excess(); };
    const double first = excess();
    EXPECT_GT(first, 1);
    bound.learn(at.step(bound, tau)->positions, tau);
    EXPECT_LT(excess(), 1);
    EXPECT_GT(excess(), 1 - (first - 1));
  }
}

// The energy of a constrained minimum, but for the discretisation error.
TEST(Scale_bound, ends_with_an_energy_that_does_not_depend_on_the_mesh)
{
  for (const double bound : {2., 4.}) {
    const End coarse = flown(dumbbell(icosphere(3), .3), bound, 60),
              fine = flown(dumbbell(icosphere(4), .3), bound, 60);
    EXPECT_TRUE(fine.report) << fine.report.message;
    EXPECT_EQ(fine.report.stop, CGP::Flow_step_report::Stop::energy_settled);
    EXPECT_LT(fine.report.steps.size(), 20U);
    EXPECT_NEAR(coarse.report.energy / fine.report.energy, 1, .015);
  }
}

// With a bound nothing is left to be smoothed beyond `Flow_options::max_spin_distortion`.
TEST(Scale_bound, lets_transformations_go_on_to_the_limits)
{
  const End end = flown(gear(10, .1, 8, 6), 4, 40);
  EXPECT_TRUE(end.report) << end.report.message;
  EXPECT_TRUE(end.report.converged());
  EXPECT_GT(end.report.bounded_steps, 0);
  EXPECT_LE(end.report.scales.excess(), 1);
  EXPECT_GT(end.report.conformality.quasi_conformal.mean, CGP::Flow_options().max_spin_distortion);
  EXPECT_LT(end.report.energy_of_faces, 1.03 * 4 * pi);
}

TEST(Scale_bound, changes_nothing_where_it_is_wide)
{
  const Mesh_view mesh = bumpy_sphere(3);
  const End plain = flown(mesh, std::nullopt), wide = flown(mesh, 100);
  EXPECT_EQ(wide.report.bounded_steps, 0);
  EXPECT_LT((plain.positions - wide.positions).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Scale_bound, is_a_number_above_1)
{
  EXPECT_THROW((void)flown(bumpy_sphere(1), 1), CGP::Precondition_error);
  EXPECT_THROW((void)flown(bumpy_sphere(1), std::nan("")), CGP::Precondition_error);
}

}  // namespace cgp_test::scale_bound_tests
