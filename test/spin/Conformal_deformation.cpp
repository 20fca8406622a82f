// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Relaxed_positions.h
#include <Conformal_geometry_processing/spin/Conformal_deformation.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "support/control_points.h"
#include "support/limbs.h"
#include "support/meshes.h"

namespace cgp_test::conformal_deformation_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::control_point;
using Deformation = CGP::internal::Conformal_deformation;
using Options = CGP::internal::Conformal_deformation_options;

Mesh_view sphere()
{
  return perturbed(icosphere(3), .02);
}

void expect_met(const Mesh_view& mesh, const std::vector<Control_point>& points, double mean_Q)
{
  Deformation deformation(mesh);
  const CGP::Spin_result r = deformation.deform(points);
  EXPECT_TRUE(r.report) << to_string(r.report.fault());
  EXPECT_EQ(r.report.reached, 1);
  const Points missed =
      CGP::internal::positions_of(points, r.positions) - CGP::internal::targets_of(points);
  const double worst = missed.colwise().norm().maxCoeff();
  EXPECT_LT(worst, 1e-8 * diagonal(mesh));
  EXPECT_NEAR(r.report.position_error.max, worst, 1e-14);
  EXPECT_EQ(r.report.conformality.flipped_faces, 0);
  EXPECT_LT(r.report.conformality.quasi_conformal.mean, mean_Q);
  EXPECT_LE(r.report.residual, 1e-8);
}

TEST(Conformal_deformation, meets_ten_targets_on_an_irregular_sphere)
{
  expect_met(sphere(), one_moved(sphere(), 10, .3), 1.05);
}

// To first order a round sphere moves only along its normals.
TEST(Conformal_deformation, meets_ten_targets_on_a_round_sphere)
{
  const Mesh_view mesh = icosphere(4);
  expect_met(mesh, one_moved(mesh, 10, .3), 1.015);
  expect_met(mesh, one_moved(mesh, 10, 1), 1.03);
}

TEST(Conformal_deformation, meets_ten_targets_on_a_disk)
{
  const Mesh_view mesh = jittered_disk(8, .1);
  expect_met(mesh, one_moved(mesh, 10, .3), 1.03);
}

TEST(Conformal_deformation, meets_targets_on_limbs)
{
  expect_met(dumbbell(3), one_moved(dumbbell(3), 10, .3), 1.04);
}

TEST(Conformal_deformation, keeps_a_torus_closed)
{
  const Mesh_view mesh = perturbed(btorus(16), .01);
  const auto points = one_moved(mesh, 10, .1);
  expect_met(mesh, points, 1.08);
  const CGP::Spin_report report = Deformation(mesh).deform(points).report;
  EXPECT_LT(report.period_defect, 1e-8);
  EXPECT_EQ(report.steps, 1);  // without targets between: the periods vanish as fast as distances
}

TEST(Conformal_deformation, moves_regions)
{
  const Mesh_view mesh = dumbbell(3);
  std::vector<int> low, high;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    if (mesh.position(v).y() < -1.5) low.push_back(v);
    if (mesh.position(v).y() > 1.5) high.push_back(v);
  }
  auto points = CGP::internal::region_control_points(mesh, low, Eigen::Affine3d::Identity());
  const Eigen::Affine3d motion =
      Eigen::Translation3d(.2, 0, 0) * Eigen::AngleAxisd(.4, Eigen::Vector3d::UnitZ());
  for (const auto& p : CGP::internal::region_control_points(mesh, high, motion))
    points.push_back(p);
  expect_met(mesh, points, 1.04);
}

TEST(Conformal_deformation, by_a_similarity_needs_no_curvature)
{
  const Mesh_view mesh = dumbbell(2);
  const Eigen::Affine3d motion = Eigen::Translation3d(1, 2, 3) *
                                 Eigen::AngleAxisd(2, Eigen::Vector3d(1, 2, 2).normalized()) *
                                 Eigen::Scaling(1.5);
  const Points moved = (motion * mesh.positions()).eval();
  for (const int count : {1, 2, 3, 8}) {
    std::vector<Control_point> points;
    for (const int v : spread_vertices(mesh, count))
      points.push_back(control_point(v, moved.col(v)));
    Deformation deformation(mesh);
    const CGP::Spin_result r = deformation.deform(points);
    EXPECT_TRUE(r.report);
    EXPECT_LT(r.report.position_error.max, 1e-8 * diagonal(mesh));
    EXPECT_LT(deformation.potential().values.cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_LT(r.report.conformality.quasi_conformal.max, 1 + 1e-8);
    if (count > 2) {
      EXPECT_LT((r.positions - moved).norm(), 1e-6 * moved.norm());
      EXPECT_NEAR(r.report.conformality.scale.max_scale, 1.5, 1e-6);
    }
  }
}

TEST(Conformal_deformation, has_the_spins_of_its_edges)
{
  const Mesh_view mesh = dumbbell(3);
  auto points = one_moved(mesh, 6, .2);
  for (auto& p : points) p.target = 2 * Eigen::Vector3d(-p.target.y(), p.target.x(), p.target.z());
  const CGP::Spin_result r = Deformation(mesh).deform(points);
  ASSERT_TRUE(r.report);
  const Eigen::MatrixX3d wanted = CGP::transformed_edges(mesh, r.lambda);
  double miss = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const auto ends = mesh.ends(k);
    const Eigen::Vector3d edge = r.positions.col(ends[1]) - r.positions.col(ends[0]);
    miss += (edge - wanted.row(k).transpose()).squaredNorm();
  }
  EXPECT_LT(std::sqrt(miss), .1 * wanted.norm());
}

TEST(Conformal_deformation, does_not_depend_on_the_order_of_targets)
{
  const Mesh_view mesh = dumbbell(2);
  auto points = one_moved(mesh, 6, .2);
  const Points first = Deformation(mesh).deform(points).positions;
  std::reverse(points.begin(), points.end());
  EXPECT_LT((Deformation(mesh).deform(points).positions - first).norm(), 1e-4 * first.norm());
}

TEST(Conformal_deformation, follows_similarities_of_mesh_and_targets)
{
  const Mesh_view mesh = dumbbell(2);
  auto points = one_moved(mesh, 6, .2);
  Deformation here(mesh);
  const Points first = here.deform(points).positions;
  const Eigen::Affine3d motion = Eigen::Translation3d(7, -2, 3) *
                                 Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 2).normalized()) *
                                 Eigen::Scaling(40.);
  for (auto& p : points) p.target = motion * p.target;
  Deformation there({(motion * mesh.positions()).eval(), mesh.corners()});
  const Points moved = (motion * first).eval(), found = there.deform(points).positions;
  EXPECT_LT((found - moved).norm(), 1e-3 * 40 * first.norm());
  const Eigen::VectorXd &rho = here.potential().values, &other = there.potential().values;
  EXPECT_LT((40 * other - rho).norm(), 1e-2 * rho.norm());  // in 1/length
}

TEST(Conformal_deformation, goes_as_far_as_it_can_without_flips)
{
  const Mesh_view mesh = dumbbell(2);
  const CGP::Spin_result r = Deformation(mesh).deform(one_moved(mesh, 10, 4));
  EXPECT_LT(r.report.reached, 1);
  EXPECT_FALSE(r.report);
  EXPECT_EQ(r.report.fault(), r.report.steps == 0 ? CGP::Spin_report::Fault::nothing_left
                                                  : CGP::Spin_report::Fault::left_out);
  EXPECT_EQ(r.report.conformality.flipped_faces, 0);
  EXPECT_GT(r.report.position_error.max, 0);
}

TEST(Conformal_deformation, with_a_weight_comes_the_nearer_the_larger_it_is)
{
  const Mesh_view mesh = sphere();
  double last = std::numeric_limits<double>::infinity();
  for (const double weight : {3., 30., 300.}) {
    Options options;
    options.position_weight = weight;
    const auto report = Deformation(mesh, options).deform(one_moved(mesh, 8, .3)).report;
    EXPECT_TRUE(report) << weight;
    EXPECT_LT(report.position_error.max, last / 2);
    last = report.position_error.max;
  }
  EXPECT_LT(last, .001 * diagonal(mesh));
}

TEST(Conformal_deformation, does_not_depend_on_the_size)
{
  const auto found = [](double size, double weight) -> Points {
    const Mesh_view mesh = scaled(dumbbell(2), size);
    Options options;
    options.position_weight = weight;
    return Deformation(mesh, options).deform(one_moved(mesh, 6, .2)).positions / size;
  };
  for (const double w : {3., std::numeric_limits<double>::infinity()})
    for (const double size : {1.1, 1.4, 1.8})
      EXPECT_LT((found(size, w) - found(1, w)).norm(), 1e-5 * found(1, w).norm()) << size;
}

TEST(Conformal_deformation, keeps_to_a_bound_on_scales)
{
  const Mesh_view mesh = dumbbell(3);
  const auto points = one_moved(mesh, 6, .3);
  const auto free = Deformation(mesh).deform(points).report.conformality.scale;
  Options options;
  options.surface.scales.bound = 1.2;
  const CGP::Spin_report report = Deformation(mesh, options).deform(points).report;
  EXPECT_TRUE(report) << to_string(report.fault());
  EXPECT_LE(report.scales.excess(), 1);
  EXPECT_LT(report.position_error.max, 1e-8 * diagonal(mesh));
  EXPECT_LE(report.conformality.scale.log_deviation, free.log_deviation * 1.001);
}

TEST(Conformal_deformation, refuses_what_makes_no_sense)
{
  const Mesh_view mesh = icosphere(1);
  Options options;
  options.position_weight = 0;
  EXPECT_THROW(Deformation(mesh, options), CGP::Precondition_error);
  options = {};
  options.surface.boundary.kind = CGP::Boundary_condition::Kind::directions;
  EXPECT_THROW(Deformation(mesh, options), CGP::Precondition_error);
  Deformation deformation(mesh);
  EXPECT_THROW((void)deformation.deform({}), CGP::Precondition_error);
  const Eigen::Vector3d p(1, 2, 3);
  EXPECT_THROW((void)deformation.deform({control_point(0, p), control_point(1, p)}),
               CGP::Precondition_error);
}

TEST(Conformal_deformation, can_be_cancelled)
{
  Deformation deformation(sphere());
  const CGP::Spin_result r = deformation.deform(
      one_moved(sphere(), 5, .3), [](const CGP::Eigensolver_progress&) { return false; });
  EXPECT_TRUE(r.report.cancelled);
  EXPECT_EQ(r.positions.cols(), 0);
}

TEST(Conformal_deformation, refuses_to_be_called_by_its_own_visitor)
{
  const auto points = one_moved(sphere(), 5, .3);
  Deformation deformation(sphere()), undisturbed(sphere());
  int refused = 0;
  const CGP::Spin_result r = deformation.deform(points, [&](const CGP::Eigensolver_progress&) {
    EXPECT_THROW((void)deformation.deform(points), CGP::Precondition_error);
    ++refused;
    return true;
  });
  EXPECT_GT(refused, 0);
  EXPECT_EQ(r.positions, undisturbed.deform(points).positions);
}

}  // namespace cgp_test::conformal_deformation_tests
