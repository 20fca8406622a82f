// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests spin/Conformal_deformation.h
#include <Conformal_geometry_processing/spin/Conformal_deformation.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Relaxed_spins.h>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

#include "support/control_points.h"
#include "support/limbs.h"
#include "support/meshes.h"

namespace cgp_test::conformal_deformation_drag_tests {

/// Control points that are dragged: one surface after the other.

namespace CGP = Conformal_geometry_processing;
using Deformation = CGP::internal::Conformal_deformation;

/// <rho, K rho>, which a deformation minimises up to 1 %. It is quadratic about its minimum, so
/// that rho itself, and with it the surface, is found up to 10 %.
double cost(const Mesh_view& mesh, const Eigen::VectorXd& rho)
{
  const CGP::internal::Dirac_system system(mesh);
  const CGP::internal::Potential_metric metric(system, .1 / system.unit());
  return metric.squared_norm(rho);
}

TEST(Conformal_deformation_drag, follows_a_drag_without_jumps)
{
  const Mesh_view mesh = dumbbell(2);
  Deformation deformation(mesh);
  Points last = mesh.positions();
  std::vector<double> steps;
  const int count = 30;
  for (int i = 1; i <= count; ++i) {
    const CGP::Spin_result r = deformation.deform(one_moved(mesh, 8, .6 * i / count));
    ASSERT_TRUE(r.report) << i;
    steps.push_back((r.positions - last).norm());
    last = r.positions;
  }
  std::sort(steps.begin(), steps.end());
  EXPECT_LT(steps.back(), 3 * steps[steps.size() / 2]);
}

// On a round sphere, bumps to either side move points along it: there are several minima, and a
// drag follows one of them.
TEST(Conformal_deformation_drag, drags_to_where_one_move_leads_at_less_cost)
{
  const Mesh_view mesh = dumbbell(3);
  Deformation deformation(mesh);
  const CGP::Spin_report first = deformation.deform(one_moved(mesh, 8, .2)).report;
  (void)deformation.deform(one_moved(mesh, 8, .21));
  const CGP::Spin_result dragged = deformation.deform(one_moved(mesh, 8, .22));
  EXPECT_TRUE(dragged.report);
  EXPECT_LT(dragged.report.position_error.max, 1e-8 * diagonal(mesh));
  EXPECT_LT(3 * dragged.report.solves, first.solves);
  Deformation other(mesh);
  const CGP::Spin_result whole = other.deform(one_moved(mesh, 8, .22));
  EXPECT_LT((dragged.positions - whole.positions).norm(),
            .2 * (whole.positions - mesh.positions()).norm());
  const Eigen::VectorXd& found = deformation.potential().values;
  const Eigen::VectorXd& at_once = other.potential().values;
  const double least = cost(mesh, at_once);
  EXPECT_NEAR(cost(mesh, found), least, .01 * least);
  EXPECT_LT(cost(mesh, found - at_once), .2 * .2 * least);
}

TEST(Conformal_deformation_drag, of_other_points_starts_anew)
{
  const Mesh_view mesh = dumbbell(2);
  Deformation deformation(mesh);
  (void)deformation.deform(one_moved(mesh, 8, .3));
  const Points found = deformation.deform(one_moved(mesh, 6, .2)).positions;
  EXPECT_EQ(found, Deformation(mesh).deform(one_moved(mesh, 6, .2)).positions);
}

// Points on a line have a shape of one number more: a similarity cannot turn it into another.
TEST(Conformal_deformation_drag, reaches_targets_on_a_line)
{
  const Mesh_view mesh = dumbbell(2);
  auto points = one_moved(mesh, 3, 0);
  const Eigen::Vector3d a = points[0].target, c = points[2].target;
  const Eigen::Vector3d along = (points[1].target - a).normalized();
  const Eigen::Vector3d on_line = a + (c - a).dot(along) * along;
  Deformation deformation(mesh);
  for (const double share : {.5, .9, 1., .9}) {
    points[2].target = c + share * (on_line - c);
    const CGP::Spin_report report = deformation.deform(points).report;
    EXPECT_TRUE(report) << share;
    EXPECT_LT(report.position_error.max, 1e-8 * diagonal(mesh)) << share;
  }
}

}  // namespace cgp_test::conformal_deformation_drag_tests
