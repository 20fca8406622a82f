// Tests include/Conformal_geometry_processing/painting/Gray_image.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/painting/Gray_image.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cgp_test::gray_image_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Gray_image;

/// 0 1 above 2 3
Gray_image four_pixels()
{
  Eigen::ArrayXXd rows(2, 2);
  rows << 0, 1, 2, 3;
  return Gray_image(rows);
}

TEST(Gray_image, has_its_pixels_where_they_are_seen)
{
  const Gray_image image = four_pixels();
  EXPECT_DOUBLE_EQ(image(0.25, 0.75), 0);
  EXPECT_DOUBLE_EQ(image(0.75, 0.75), 1);
  EXPECT_DOUBLE_EQ(image(0.25, 0.25), 2);
  EXPECT_DOUBLE_EQ(image(0.75, 0.25), 3);
  EXPECT_EQ(Gray_image(Eigen::ArrayXXd::Zero(2, 3)).width(), 3);
  EXPECT_EQ(Gray_image(Eigen::ArrayXXd::Zero(2, 3)).height(), 2);
}

TEST(Gray_image, is_linear_between_the_middles_of_pixels_and_constant_at_the_border)
{
  const Gray_image image = four_pixels();
  EXPECT_DOUBLE_EQ(image(0.5, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(image(0.375, 0.75), 0.25);
  EXPECT_DOUBLE_EQ(image(0.25, 0.625), 0.5);
  EXPECT_DOUBLE_EQ(image(1, 0), 3);
  EXPECT_DOUBLE_EQ(image(0, 1), 0);
  EXPECT_DOUBLE_EQ(image(0.5, 1), 0.5);
}

TEST(Gray_image, shows_linear_functions_as_they_are)
{
  Eigen::ArrayXXd rows(7, 5);
  for (int r = 0; r < 7; ++r)
    for (int c = 0; c < 5; ++c) rows(r, c) = 2 * (c + 0.5) / 5 - 3 * (1 - (r + 0.5) / 7);
  const Gray_image image(rows);
  for (const double u : {0.1, 0.33, 0.6, 0.9})
    for (const double v : {0.08, 0.4, 0.77, 0.92}) EXPECT_NEAR(image(u, v), 2 * u - 3 * v, 1e-14);
}

TEST(Gray_image, repeats_itself_outside)
{
  const Gray_image image = four_pixels();
  EXPECT_DOUBLE_EQ(image(1.75, 0.25), 3);
  EXPECT_DOUBLE_EQ(image(-0.25, 2.25), 3);
  EXPECT_DOUBLE_EQ(image(1e300, 0.5), image(0, 0.5));
}

TEST(Gray_image, gives_the_values_at_many_places)
{
  Eigen::Matrix2Xd places(2, 3);
  places << 0.25, 0.5, 1, 0.75, 0.5, 0;
  EXPECT_EQ(four_pixels()(places), Eigen::Vector3d(0, 1.5, 3));
}

TEST(Gray_image, has_no_value_where_a_coordinate_is_none)
{
  EXPECT_TRUE(std::isnan(four_pixels()(std::nan(""), 0)));
  EXPECT_TRUE(std::isnan(four_pixels()(0, std::numeric_limits<double>::infinity())));
}

TEST(Gray_image, has_pixels)
{
  EXPECT_THROW(Gray_image(Eigen::ArrayXXd(0, 3)), CGP::Precondition_error);
}

}  // namespace cgp_test::gray_image_tests
