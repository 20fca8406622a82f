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

// What is small now counts by its size in the beginning, and has as much left as it has not used.
TEST(Scale_bound, asks_the_next_surface_for_what_is_left)
{
  const Mesh_view mesh = bumpy_sphere(2);
  Mesh_view small = mesh;
  Points f = mesh.positions();
  f.colwise() -= Eigen::Vector3d(0, 0, 1.5);
  f.array().rowwise() /= f.colwise().squaredNorm().array();
  small.set_positions(f);
  const Scale_bound bound(mesh, 3);
  const CGP::internal::Scale_control control = bound.control(small, 1);
  const Eigen::VectorXd u = vertex_log_scales(mesh, f);
  EXPECT_LT((control.factors.array().log() + u.array()).abs().maxCoeff(), 1e-12);
  const Eigen::VectorXd areas = control.weights.cwiseProduct(CGP::vertex_areas(small));
  EXPECT_LT((areas - CGP::vertex_areas(mesh)).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE(*control.bound, 3);
  EXPECT_GE(*control.bound, 2.9);
  const Eigen::VectorXd before = CGP::vertex_areas(mesh);
  const double growth = (2 * u.array()).exp().matrix().dot(before) / before.sum();
  EXPECT_EQ(*bound.control(small, 0).bound, 3);  // it is beyond
  EXPECT_NEAR(bound.measured(f).max, std::exp(u.maxCoeff()) / std::sqrt(growth), 1e-12);
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

/// a surface that has used nearly all of its bound
struct At_bound {
  At_bound()
  {
    Points f = mesh.positions();
    f.colwise() -= Eigen::Vector3d(0, 0, 1.5);
    f.array().rowwise() /= f.colwise().squaredNorm().array();
    moved.set_positions(f);
    used = std::log(2.) * Scale_bound(mesh, 2).measured(f).excess();
  }

  Mesh_view mesh = bumpy_sphere(3), moved = mesh;
  double used;
  Scale_bound bound() const { return {mesh, std::exp(used / .995)}; }
};

TEST(Scale_bound, asks_small_steps_for_less_room)
{
  const At_bound at;
  const Scale_bound bound = at.bound();
  EXPECT_NEAR(bound.measured(at.moved.positions()).excess(), .995, 1e-9);
  double last = *bound.control(at.moved, 0).bound;
  EXPECT_GT(std::log(last), at.used);
  for (const double time : {.2, .5, 1.}) {
    const double next = *bound.control(at.moved, time).bound;
    EXPECT_LT(next, last);
    EXPECT_GE(std::log(next), .98 * at.used / .995 - 1e-12);
    last = next;
  }
}

// Otherwise the energy would rise by as much in the smallest step, and the flow end.
TEST(Scale_bound, moves_lengths_by_no_more_than_the_step)
{
  const At_bound at;
  CGP::Spin_transformation transformation(at.moved);
  const Eigen::VectorXd rho = .3 * CGP::mean_curvature(at.moved);
  const std::vector<double> times{.25, .0625};
  std::vector<double> changes;
  for (const double time : times) {
    const CGP::Spin_result result = at.bound().step(transformation, at.moved, time * rho, time,
                                                    [](const auto&) { return true; });
    const Eigen::VectorXd u = vertex_log_scales(at.moved, result.positions);
    changes.push_back((u.array() - u.mean()).abs().mean());
  }
  EXPECT_GT(slope(times, changes), .7);
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
