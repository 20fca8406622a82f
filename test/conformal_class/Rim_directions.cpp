// Tests include/Conformal_geometry_processing/conformal_class/Rim_directions.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/conformal_class/Conformal_class.h>
#include <Conformal_geometry_processing/conformal_class/Rim_directions.h>
#include <Conformal_geometry_processing/measure/distortion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/bounded_meshes.h"
#include "support/random.h"

namespace cgp_test::rim_directions_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Rim_directions;

/// tangents, normals, binormals, and a direction between them
const std::vector<Eigen::Vector3d>& kinds()
{
  static const std::vector<Eigen::Vector3d> list = {
      Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), {1, -2, 3}};
  return list;
}

Mesh_view surface()
{
  return perturbed(cap_from_disk(disk(6), pi / 3), .01);
}

Points moved(const Mesh_view& mesh, double by)
{
  return mesh.positions() +
         by * random_numbers(3 * mesh.size_of_vertices(), 7).reshaped(3, mesh.size_of_vertices());
}

TEST(Rim_directions, has_two_residuals_for_each_edge_that_motions_and_scalings_leave)
{
  const Mesh_view mesh = surface();
  EXPECT_EQ(Rim_directions().size_of_rows(), 0);
  for (const Eigen::Vector3d& kind : kinds()) {
    const Rim_directions rim(mesh, kind);
    EXPECT_EQ(rim.size_of_rows(), 2 * 36);
    const Points f = (3 * mesh.positions()).colwise() + Eigen::Vector3d(1, 2, 3);
    EXPECT_LT(rim.residuals(f).lpNorm<Eigen::Infinity>(), 1e-13);
    EXPECT_GT(rim.residuals(moved(mesh, .01)).lpNorm<Eigen::Infinity>(), 1e-3);
  }
}

TEST(Rim_directions, are_angles)
{
  const Mesh_view mesh = surface();
  const double angle = 1e-4;
  const Eigen::Matrix3d R =
      Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 1, 2).normalized()).toRotationMatrix();
  const Eigen::VectorXd r = Rim_directions(mesh, {0, 0, 1}).residuals(R * mesh.positions());
  EXPECT_LT(r.lpNorm<Eigen::Infinity>(), angle);
  EXPECT_GT(r.lpNorm<Eigen::Infinity>(), .5 * angle);
}

TEST(Rim_directions, derivative_is_that_of_the_residuals)
{
  const Mesh_view mesh = surface();
  for (const Eigen::Vector3d& kind : kinds()) {
    const Rim_directions rim(mesh, kind);
    const Points v = moved(mesh, 1) - mesh.positions();
    const double t = 1e-6;
    const Eigen::VectorXd difference =
        (rim.residuals(mesh.positions() + t * v) - rim.residuals(mesh.positions() - t * v)) /
        (2 * t);
    Eigen::VectorXd derivative = Eigen::VectorXd::Zero(rim.size_of_rows());
    Eigen::Index k = 0;
    for (const Rim_directions::Row& row : rim.derivative(mesh.positions())) {
      for (int c = 0; c < 3; ++c)
        derivative[k] += row.gradients.col(c).dot(v.col(row.vertices[at(c)]));
      ++k;
    }
    EXPECT_EQ(k, rim.size_of_rows());
    EXPECT_LT((derivative - difference).norm(), 1e-7 * difference.norm());
  }
}

TEST(Rim_directions, are_kept_on_the_way_to_the_conformal_class)
{
  const Mesh_view mesh = surface();
  const Points before = moved(mesh, .003);
  for (const Eigen::Vector3d& kind : {kinds()[0], kinds()[2], kinds()[3]}) {
    SCOPED_TRACE(kind.transpose());
    CGP::internal::Conformal_class conformal_class(mesh);
    const Rim_directions rim({before, mesh.corners()}, kind);
    conformal_class.keep(rim);
    Points f = before;
    const CGP::internal::Snap_report report = conformal_class.snap(f);
    EXPECT_TRUE(report.converged);
    EXPECT_GT(report.initial_residual, 1e-3);
    EXPECT_LT(CGP::length_cross_ratio_change(mesh, f).max, 1e-10);
    EXPECT_LT(rim.residuals(f).lpNorm<Eigen::Infinity>(), 1e-10);
  }
}

}  // namespace cgp_test::rim_directions_tests
