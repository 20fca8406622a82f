// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/measure/Conformality.h
#include <Conformal_geometry_processing/measure/Conformality.h>

#include <gtest/gtest.h>

#include <cmath>

#include "support/meshes.h"

namespace {

using namespace cgp_test;
namespace CGP = Conformal_geometry_processing;

Points upward(const Mesh_view& mesh)
{
  return Eigen::Vector3d::UnitZ().replicate(1, mesh.size_of_faces());
}

}  // namespace

TEST(Conformality, of_a_similarity_is_perfect)
{
  const Mesh_view mesh = grid(4, 3);
  Random random(5);
  const Eigen::Matrix3d R = random.rotation();
  const Points moved = (2.5 * R * mesh.positions()).colwise() + random.vector();
  const CGP::Conformality c = CGP::conformality(mesh, moved, R * upward(mesh));
  EXPECT_NEAR(c.quasi_conformal.mean, 1, 1e-14);
  EXPECT_NEAR(c.quasi_conformal.max, 1, 1e-14);
  EXPECT_NEAR(c.length_cross_ratio.max, 0, 1e-14);
  EXPECT_NEAR(c.scale.min_scale, 2.5, 1e-13);
  EXPECT_NEAR(c.scale.max_scale, 2.5, 1e-13);
  EXPECT_EQ(c.flipped_faces, 0);
}

TEST(Conformality, of_a_stretch_and_a_reflection_shows_in_every_part)
{
  const Mesh_view mesh = grid(1, 1);
  const Points moved = Eigen::Vector3d(3, -1, 1).asDiagonal() * mesh.positions();
  const CGP::Conformality c = CGP::conformality(mesh, moved, upward(mesh));
  EXPECT_NEAR(c.quasi_conformal.mean, 3, 1e-14);
  EXPECT_NEAR(c.quasi_conformal.p99, 3, 1e-14);
  // The two sides along x grow by 3, those along y by 1: the cross-ratio of the diagonal by 9.
  EXPECT_NEAR(c.length_cross_ratio.max, std::log(9.), 1e-14);
  EXPECT_NEAR(c.scale.max_scale, std::sqrt(3.), 1e-14);
  EXPECT_EQ(c.flipped_faces, 2);
}
