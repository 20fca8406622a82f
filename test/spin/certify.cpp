// Tests include/Conformal_geometry_processing/spin/certify.h
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Surface_dirac_equation.h>
#include <Conformal_geometry_processing/spin/certify.h>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <limits>

#include "support/bounded_meshes.h"
#include "support/meshes.h"

namespace {

using namespace cgp_test;
namespace CGP = Conformal_geometry_processing;
using CGP::Boundary_condition;
using Quaternions = CGP::Quaternion_vector<double>;

Quaternions ones(const Mesh_view& mesh)
{
  return Quaternions::Constant(mesh.size_of_vertices(), {1, 0, 0, 0});
}

TEST(Certify, of_a_similarity_finds_no_error)
{
  const Mesh_view mesh = bumpy_sphere(2);
  Quaternions lambda = ones(mesh);
  lambda[3] *= .25;
  CGP::Spin_report report;
  report.converged = true;
  CGP::internal::certify(mesh, 3 * mesh.positions(), lambda, report);
  EXPECT_TRUE(report.converged);
  EXPECT_NEAR(report.conformality.quasi_conformal.max, 1, 1e-6);
  EXPECT_EQ(report.conformality.flipped_faces, 0);
  EXPECT_EQ(report.min_spin_ratio, .25);
}

TEST(Certify, does_not_let_pass_what_is_no_number)
{
  const Mesh_view mesh = icosphere(1);
  Points f = mesh.positions();
  f(1, 5) = std::numeric_limits<double>::quiet_NaN();
  CGP::Spin_report report;
  report.converged = true;
  CGP::internal::certify(mesh, f, ones(mesh), report);
  EXPECT_FALSE(report.converged);
}

TEST(Judge_boundary, measures_by_how_much_prescribed_directions_are_missed)
{
  const Mesh_view mesh = disk(3);
  Boundary_condition condition = Boundary_condition::tangents();
  const CGP::Surface_dirac_equation<> dirac(mesh, condition, "test");
  const auto judged = [&](const Mesh_view& moved, bool is_finite) {
    CGP::Spin_report report;
    bool is_asked = false;
    const auto surface = [&] {
      is_asked = true;
      return moved;
    };
    CGP::internal::judge_boundary(mesh, surface, is_finite, dirac, 1, report);
    EXPECT_EQ(is_asked, is_finite);
    return report;
  };
  EXPECT_LT(judged(mesh, true).direction_error.max, 1e-7);
  const double angle = .1;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).matrix();
  const Mesh_view turned(turn * mesh.positions(), mesh.corners());
  EXPECT_NEAR(judged(turned, true).direction_error.mean, angle, 1e-6);
  EXPECT_TRUE(std::isnan(judged(mesh, false).direction_error.mean));
}

}  // namespace
