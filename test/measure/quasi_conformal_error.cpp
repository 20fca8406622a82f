// Tests include/Conformal_geometry_processing/measure/distortion.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/distortion.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/moebius.h"

namespace cgp_test::quasi_conformal_error_tests {

namespace CGP = Conformal_geometry_processing;

Points times(const Eigen::Matrix3d& A, const Mesh_view& mesh)
{
  return A * mesh.positions();
}

TEST(Quasi_conformal_errors, of_a_linear_map_are_the_quotient_of_its_singular_values)
{
  Eigen::Matrix3d stretch = Eigen::Vector3d(6, 2, 1).asDiagonal();
  const Eigen::Matrix3d before = Eigen::AngleAxisd(.7, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Matrix3d after = Random(1).rotation();
  const Eigen::VectorXd Q =
      CGP::quasi_conformal_errors(disk(3), times(after * stretch * before, disk(3)));
  EXPECT_LT((Q.array() - 3).abs().maxCoeff(), 1e-12);
}

TEST(Quasi_conformal_errors, of_a_shear_are_known)
{
  // (1 s; 0 1) has singular values whose sum of squares is 2 + s^2 and whose product is 1.
  const double s = .6, t = 2 + s * s, wanted = (t + std::sqrt(t * t - 4)) / 2;
  Eigen::Matrix3d shear = Eigen::Matrix3d::Identity();
  shear(0, 1) = s;
  const Eigen::VectorXd Q = CGP::quasi_conformal_errors(disk(2), times(shear, disk(2)));
  EXPECT_LT((Q.array() - wanted).abs().maxCoeff(), 1e-13);
}

TEST(Quasi_conformal_errors, of_similarities_and_reflections_are_one)
{
  const Mesh_view mesh = perturbed(icosphere(2), .05);
  const Points moved = times(3 * Random(2).rotation(), mesh).colwise() + Eigen::Vector3d(4, 5, 6);
  EXPECT_LT((CGP::quasi_conformal_errors(mesh, moved).array() - 1).abs().maxCoeff(), 1e-12);
  EXPECT_LT((CGP::quasi_conformal_errors(mesh, -moved).array() - 1).abs().maxCoeff(), 1e-12);
}

TEST(Quasi_conformal_errors, are_the_same_for_the_inverse_map_and_at_least_one)
{
  const Mesh_view mesh = icosphere(1), other = perturbed(mesh, .2);
  const Eigen::VectorXd Q = CGP::quasi_conformal_errors(mesh, other.positions());
  EXPECT_LT((CGP::quasi_conformal_errors(other, mesh.positions()) - Q).norm(), 1e-11);
  EXPECT_GE(Q.minCoeff(), 1);
}

TEST(Quasi_conformal_errors, do_not_depend_on_which_corner_comes_first)
{
  const Mesh_view mesh = icosphere(1), other = perturbed(mesh, .2);
  Corners turned = mesh.corners();
  for (auto& v : turned) v = {v[1], v[2], v[0]};
  const Eigen::VectorXd Q = CGP::quasi_conformal_errors(mesh, other.positions());
  const Eigen::VectorXd P =
      CGP::quasi_conformal_errors(Mesh_view(mesh.positions(), turned), other.positions());
  EXPECT_LT((P - Q).norm(), 1e-11);
}

TEST(Quasi_conformal_errors, are_accurate_where_huge)
{
  const double thin = 1e-12;
  Eigen::Matrix3d squash = Eigen::Vector3d(1, thin, 1).asDiagonal();
  const Eigen::VectorXd Q =
      CGP::quasi_conformal_errors(unit_square(), times(squash, unit_square()));
  EXPECT_LT((Q * thin).array().maxCoeff() - 1, 1e-12);
  EXPECT_GT((Q * thin).array().minCoeff() - 1, -1e-12);
}

TEST(Quasi_conformal_errors, are_infinite_where_a_face_collapses)
{
  Points p = unit_square().positions();
  p.col(3) << 2, 2, 0;  // in line with the diagonal
  EXPECT_NEAR(CGP::quasi_conformal_errors(unit_square(), p)[0], 1, 1e-15);
  EXPECT_EQ(CGP::quasi_conformal_errors(unit_square(), p)[1], HUGE_VAL);
  p = Points::Zero(3, 4);
  EXPECT_EQ(CGP::quasi_conformal_errors(unit_square(), p)[0], HUGE_VAL);
}

TEST(Quasi_conformal_error, of_conformal_maps_is_of_first_order)
{
  std::vector<double> h, error;
  for (int level : {2, 3, 4}) {
    const Mesh_view mesh = bumpy_sphere(level);
    h.push_back(mean_edge_length(mesh));
    const Points moved = inverted(mesh, {.3, .1, 2.5}).positions();
    error.push_back(CGP::quasi_conformal_error(mesh, moved).mean - 1);
  }
  EXPECT_NEAR(slope(h, error), 1, .1);
}

TEST(Quasi_conformal_error, weighs_by_the_old_areas)
{
  // Areas 1 and 3; the second face is stretched by 2 across the common edge.
  const Mesh_view mesh(points({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, -3, 0}}),
                       {{0, 1, 2}, {0, 3, 1}});
  Points p = mesh.positions();
  p(1, 3) *= 2;
  const CGP::internal::Distribution Q = CGP::quasi_conformal_error(mesh, p);
  EXPECT_NEAR(Q.mean, (1 + 3 * 2) / 4., 1e-14);
  EXPECT_NEAR(Q.p99, 2, 1e-14);
  EXPECT_NEAR(Q.max, 2, 1e-14);
}

}  // namespace cgp_test::quasi_conformal_error_tests
