// Tests mesh/Mesh_view.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <gtest/gtest.h>

#include <cmath>

namespace cgp_test::stable_norm_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Stable_norm, is_the_length_at_every_size)
{
  const Eigen::Vector3d v(2, -3, 6);  // of length 7
  for (double size : {1., 1e-300, 1e300})
    EXPECT_NEAR(CGP::stable_norm(size * v) / (7 * size), 1, 4e-16);
  EXPECT_EQ(CGP::stable_norm(Eigen::Vector3d::Zero()), 0);
  EXPECT_TRUE(std::isnan(CGP::stable_norm({1, std::nan(""), 0})));
}

TEST(Stable_norm, makes_units_of_every_size)
{
  const Eigen::Vector3d v(2, -3, 6);
  for (double size : {1., 1e-300, 1e300})
    EXPECT_LE((CGP::stable_normalized(size * v) - v / 7).norm(), 4e-16);
}

TEST(Stable_norm, leaves_zero_where_it_is)
{
  EXPECT_EQ(CGP::stable_normalized(Eigen::Vector3d::Zero()), Eigen::Vector3d::Zero());
}

}  // namespace cgp_test::stable_norm_tests
