// Tests include/Conformal_geometry_processing/measure/alignment.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/alignment.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::alignment_tests {

namespace CGP = Conformal_geometry_processing;

Points similar(const Points& p, const Eigen::Matrix3d& R, double scale, const Eigen::Vector3d& t)
{
  return (scale * R * p).colwise() + t;
}

TEST(Align, recovers_a_similarity)
{
  const Points source = bumpy_sphere(2).positions();
  for (unsigned seed : {1u, 2u, 3u}) {
    const Eigen::Matrix3d R = Random(seed).rotation();
    const Eigen::Vector3d t(5, -6, 7);
    const CGP::internal::Alignment a = CGP::align(source, similar(source, R, 2.5, t));
    EXPECT_LT((a.rotation - R).norm(), 1e-13);
    EXPECT_NEAR(a.scale, 2.5, 1e-13);
    EXPECT_LT((a.translation - t).norm(), 1e-12);
    EXPECT_LT(a.rms, 1e-14);
    EXPECT_LT(a.max, 1e-14);
  }
}

TEST(Align, does_not_depend_on_the_units_of_both)
{
  const Points source = bumpy_sphere(2).positions(),
               target = radially_perturbed(bumpy_sphere(2), .1).positions();
  const CGP::internal::Alignment a = CGP::align(source, target);
  for (const double unit : {1e-150, 1e-80, 1e150})
    for (const double other : {1., unit}) {
      const CGP::internal::Alignment b = CGP::align(unit * source, other * target);
      EXPECT_NEAR(b.scale * (unit / other), a.scale, 1e-12) << unit;
      EXPECT_NEAR(b.rms, a.rms, 1e-12) << unit;
      EXPECT_LT((b.rotation - a.rotation).norm(), 1e-12) << unit;
    }
}

TEST(Align, recovers_a_similarity_of_plane_points)
{
  const Points source = disk(3).positions();
  const Eigen::Matrix3d R = Random(4).rotation();
  const CGP::internal::Alignment a = CGP::align(source, similar(source, R, .3, {1, 2, 3}));
  EXPECT_LT((a.rotation - R).norm(), 1e-13);
  EXPECT_LT(a.max, 1e-14);
}

TEST(Align, never_reflects)
{
  const Points source = bumpy_sphere(2).positions();
  const CGP::internal::Alignment a = CGP::align(source, -source);
  EXPECT_NEAR(a.rotation.determinant(), 1, 1e-14);
  EXPECT_LT((a.rotation * a.rotation.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  EXPECT_GT(a.rms, 1e-3);
}

TEST(Align, measures_what_is_left_relative_to_the_diagonal_of_the_target)
{
  // Four corners of a rectangle, and the same moved along its normal by turns: +d, -d, +d, -d
  // cannot be undone by a similarity. Half diagonal 5.
  const double d = .01;
  const Points source = points({{-3, -4, 0}, {3, -4, 0}, {3, 4, 0}, {-3, 4, 0}});
  const Points target = points({{-3, -4, d}, {3, -4, -d}, {3, 4, d}, {-3, 4, -d}});
  const CGP::internal::Alignment a = CGP::align(source, target);
  EXPECT_NEAR(a.rms, d / 10, 1e-8);
  EXPECT_NEAR(a.max, d / 10, 1e-8);
  const CGP::internal::Alignment b = CGP::align(7 * source, 7 * target);
  EXPECT_NEAR(b.rms, a.rms, 1e-14);
}

TEST(Align, is_the_best_among_its_neighbours)
{
  const Points source = bumpy_sphere(1).positions();
  const Points target = perturbed(bumpy_sphere(1), .1).positions();
  const CGP::internal::Alignment best = CGP::align(source, target);
  const double least = (best.apply(source) - target).norm();
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    CGP::internal::Alignment other = best;
    other.rotation = Eigen::AngleAxisd(.01, random.vector().normalized()) * best.rotation;
    other.scale *= 1 + .01 * random.number();
    other.translation += .01 * random.vector();
    EXPECT_GT((other.apply(source) - target).norm(), least);
  }
}

}  // namespace cgp_test::alignment_tests
