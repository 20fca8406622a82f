// Tests include/Conformal_geometry_processing/spin/certify.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/certify.h>

#include <gtest/gtest.h>

#include <limits>

#include "support/meshes.h"

namespace cgp_test::certify_tests {

namespace CGP = Conformal_geometry_processing;
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

}  // namespace cgp_test::certify_tests
