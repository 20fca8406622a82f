// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Nearest_spin_transformation.h
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"
#include "support/thin_faces.h"

namespace cgp_test::nearest_spin_transformation_handles_tests {

namespace CGP = Conformal_geometry_processing;

/// the tube made thicker on one side: no conformal map, but a smooth one
Points deformed(const Mesh_view& mesh)
{
  return mapped(mesh,
                [](const Eigen::Vector3d& p) {
                  const double r = std::hypot(p.x(), p.y());
                  const Eigen::Vector3d centre(3 * p.x() / r, 3 * p.y() / r, 0);
                  const double s = .7 * std::exp((p.x() / r - 1) * 2);
                  return Eigen::Vector3d(centre + (1 + s) * (p - centre));
                })
      .positions();
}

TEST(Nearest_spin_transformation_of_handles, closes_up_as_spin_transformations_do)
{
  const Mesh_view mesh = torus(3, 1, 48, 24);
  CGP::Nearest_spin_options closed;
  closed.keep_curvature = true;
  CGP::Nearest_spin_transformation near(mesh, deformed(mesh), "test", closed);
  const CGP::Nearest_spin_result result = near.transform();
  ASSERT_TRUE(result.report);
  EXPECT_LT(result.report.period_defect, .02);
  EXPECT_LT(result.report.closure_residual, .005);
  EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.03);
  CGP::Nearest_spin_options open = closed;
  open.surface.exactness.reset();
  CGP::Nearest_spin_transformation plain(mesh, deformed(mesh), "test", open);
  const CGP::Nearest_spin_result sheared = plain.transform();
  EXPECT_GT(sheared.report.closure_residual, 10 * result.report.closure_residual);
  const CGP::Nearest_spin_result again = near.transform();
  EXPECT_EQ(again.positions, result.positions);
}

TEST(Nearest_spin_transformation_of_handles, takes_thin_faces)
{
  const Mesh_view clean = torus(3, 1, 48, 24), mesh = with_thin_faces(clean, 0);
  EXPECT_THROW(CGP::Nearest_spin_transformation(mesh, deformed(mesh)), CGP::Precondition_error);
  CGP::Nearest_spin_options options;
  options.surface.mollification = 1e-6;
  options.keep_curvature = true;
  CGP::Nearest_spin_options plain;
  plain.keep_curvature = true;
  CGP::Nearest_spin_transformation near(mesh, deformed(mesh), "test", options),
      expected(clean, deformed(clean), "test", plain);
  const CGP::Nearest_spin_result result = near.transform();
  ASSERT_TRUE(result.report);
  EXPECT_EQ(near.sign_conflicts(), 0);
  EXPECT_LT(result.report.closure_residual, .01);
  EXPECT_LT(result.report.conformality.quasi_conformal.mean, 1.06);
  const Points of_clean = expected.transform().positions;
  EXPECT_LT(CGP::align(Points(result.positions.leftCols(of_clean.cols())), of_clean).max, .05);
}

}  // namespace cgp_test::nearest_spin_transformation_handles_tests
