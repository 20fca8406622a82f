// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spin_transformation.h
// The realised change of curvature of its results.
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/bounded_meshes.h"
#include "support/limbs.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::spin_transformation_realised_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_potential;

Curvature_potential waves(const Mesh_view& mesh, double amplitude)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v)
    rho[v] = amplitude * std::sin(2 * mesh.position(v).y() + mesh.position(v).x());
  return Curvature_potential::on_vertices(rho);
}

TEST(Spin_transformation_realised, change_of_curvature_tends_to_rho)
{
  std::vector<double> distances;
  for (int level : {2, 3, 4}) {
    const Mesh_view mesh = bumpy_sphere(level);
    const CGP::Spin_result result = CGP::Spin_transformation(mesh).transform(waves(mesh, .3));
    ASSERT_TRUE(result.report.realised_curvature);
    distances.push_back(result.report.realised_curvature->distance);
    EXPECT_EQ(result.report.realised_curvature->wrong_sign, 0);
    EXPECT_FALSE(result.report.falls_short());
  }
  EXPECT_GT(distances[0] / distances[1], 1.9) << distances[0];  // slope .9
  EXPECT_GT(distances[1] / distances[2], 1.9) << distances[1];
  EXPECT_LT(distances[2], .05);
}

TEST(Spin_transformation_realised, change_of_curvature_is_measured_for_all_that_is_returned)
{
  const Mesh_view mesh = scan(800);
  const Curvature_potential rho = waves(mesh, .3);
  CGP::Spin_transformation transformation(mesh);
  const auto all = transformation.transform(rho).report.realised_curvature;
  ASSERT_TRUE(all);
  EXPECT_GT(all->agreement(), .75);
  const auto step = transformation.step(rho).report.realised_curvature;
  ASSERT_TRUE(step);
  EXPECT_EQ(step->share, all->share);
  EXPECT_EQ(CGP::Spin_transformation(mesh).transform(rho).report.realised_curvature->share,
            all->share);
  EXPECT_FALSE(transformation.trial_step(rho).report.realised_curvature);
  const auto opposite = Curvature_potential::on_vertices(-rho.values);
  EXPECT_GT(transformation.transform(opposite).report.realised_curvature->agreement(), .75);
}

TEST(Spin_transformation_realised, change_of_curvature_is_that_of_all_of_rho_under_a_bound)
{
  const Mesh_view mesh = dumbbell(3);
  CGP::Spin_transformation_options bounded;
  bounded.scales.bound = 1.2;
  const Curvature_potential rho = waves(mesh, 3);
  const CGP::Spin_report report = CGP::Spin_transformation(mesh, bounded).transform(rho).report;
  ASSERT_TRUE(report.realised_curvature);
  EXPECT_GT(report.scales.weight, 0);
  EXPECT_LT(report.realised_curvature->share, .7);
  EXPECT_TRUE(report.falls_short());
}

TEST(Spin_transformation_realised, change_of_curvature_with_handles_is_measured_from_the_start)
{
  const Mesh_view mesh = torus(1, .4, 48, 24);
  CGP::Spin_transformation transformation(mesh);
  const CGP::Spin_result result = transformation.transform(waves(mesh, .3));
  ASSERT_TRUE(result.report.realised_curvature);
  EXPECT_NEAR(result.report.realised_curvature->correlation, result.report.realised_share, .2);
  EXPECT_EQ(
      CGP::Spin_transformation(mesh).transform(waves(mesh, .3)).report.realised_curvature->share,
      result.report.realised_curvature->share);
}

TEST(Spin_transformation_realised, change_of_curvature_is_finite_on_thin_faces)
{
  const Mesh_view mesh = spoilt(bumpy_sphere(3));
  CGP::Spin_transformation_options mollified;
  mollified.mollification = 1e-6;
  const auto found = CGP::Spin_transformation(mesh, mollified)
                         .transform(waves(mesh, .3))
                         .report.realised_curvature;
  ASSERT_TRUE(found);
  EXPECT_GT(found->agreement(), .8);
  EXPECT_LT(found->share, 1.2);
}

TEST(Spin_transformation_realised, change_of_curvature_of_surfaces_with_boundary_leaves_out_the_rim)
{
  const Mesh_view mesh = grid(24, 24);
  const auto found =
      CGP::Spin_transformation(mesh).transform(waves(mesh, 1)).report.realised_curvature;
  ASSERT_TRUE(found);
  EXPECT_LT(found->judged_share, 1);
  EXPECT_GT(found->agreement(), .8);
}

TEST(Spin_transformation_realised, change_of_curvature_has_no_unit)
{
  const Mesh_view mesh = scan(400);
  const Curvature_potential rho = waves(mesh, .3);
  const auto found = CGP::Spin_transformation(mesh).transform(rho).report.realised_curvature;
  const double unit = .01;
  const auto other = CGP::Spin_transformation({unit * mesh.positions(), mesh.corners()})
                         .transform(Curvature_potential::on_vertices(rho.values / unit))
                         .report.realised_curvature;
  EXPECT_NEAR(other->share, found->share, 1e-6);
  EXPECT_NEAR(other->correlation, found->correlation, 1e-6);
  const auto raised =
      CGP::Spin_transformation(mesh)
          .transform(Curvature_potential::on_vertices((rho.values.array() + .4).matrix()))
          .report.realised_curvature;
  EXPECT_NEAR(raised->share, found->share, 1e-5);
}

}  // namespace cgp_test::spin_transformation_realised_tests
