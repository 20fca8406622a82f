// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/painting/image_filters.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include "support/random.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cgp_test::image_filters_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Curvature_band;
using CGP::Gray_image;
using Pixels = Eigen::ArrayXXd;

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

Pixels random_pixels(int rows, int columns)
{
  cgp_test::Random random(7);
  return Pixels::NullaryExpr(rows, columns, [&] { return random.number(); });
}

Pixels blurred(const Pixels& pixels, double radius)
{
  return CGP::blurred(Gray_image(pixels), radius).pixels();
}

Pixels filtered(const Pixels& pixels, Curvature_band band, double amount = 1)
{
  return CGP::filtered(Gray_image(pixels), band, 2, amount).pixels();
}

/// the mean over the whole picture, weighted by the Gauss function of the distance
Pixels gauss_mean(const Pixels& pixels, double radius)
{
  Pixels result(pixels.rows(), pixels.cols());
  for (Eigen::Index r = 0; r < pixels.rows(); ++r)
    for (Eigen::Index c = 0; c < pixels.cols(); ++c) {
      double sum = 0, weights = 0;
      for (Eigen::Index s = 0; s < pixels.rows(); ++s)
        for (Eigen::Index d = 0; d < pixels.cols(); ++d) {
          const double distance = std::hypot(r - s, c - d);
          const double weight = std::exp(-distance * distance / (2 * radius * radius));
          sum += weight * pixels(s, d);
          weights += weight;
        }
      result(r, c) = sum / weights;
    }
  return result;
}

double greatest(const Pixels& difference)
{
  return difference.abs().maxCoeff();
}

TEST(Blurred, is_the_mean_weighted_by_the_gauss_function_also_at_the_border)
{
  const Pixels pixels = random_pixels(23, 17);
  for (const double radius : {0.7, 2., 9.})
    EXPECT_LT(greatest(blurred(pixels, radius) - gauss_mean(pixels, radius)), 1e-5) << radius;
}

TEST(Blurred, keeps_constants_to_the_border_and_linear_functions_away_from_it)
{
  EXPECT_LT(greatest(blurred(Pixels::Constant(9, 30, 0.3), 4) - 0.3), 1e-15);
  const Pixels ramp = Eigen::VectorXd::LinSpaced(60, 0, 1).transpose().replicate(5, 1);
  const Pixels change = blurred(ramp, 3) - ramp;
  EXPECT_LT(greatest(change.middleCols(15, 30)), 1e-15);
  EXPECT_GT(greatest(change), 1e-3);
}

TEST(Blurred, spreads_a_pixel_by_the_variance_of_its_radius)
{
  Pixels point = Pixels::Zero(121, 121);
  point(60, 60) = 1;
  const double radius = 5;
  const Pixels spread = blurred(point, radius);
  double total = 0, variance = 0;
  for (int c = 0; c < 121; ++c) {
    total += spread.col(c).sum();
    variance += (c - 60) * (c - 60) * spread.col(c).sum();
  }
  EXPECT_NEAR(total, 1, 1e-12);
  EXPECT_NEAR(variance, radius * radius, 1e-4 * radius * radius);
  EXPECT_LT(greatest(spread - spread.transpose()), 1e-16);
}

TEST(Blurred, twice_is_blurred_once_by_more)
{
  Pixels point = Pixels::Zero(81, 81);
  point(38, 41) = 1;
  EXPECT_LT(greatest(blurred(blurred(point, 3), 4) - blurred(point, 5)), 1e-8);
}

TEST(Blurred, by_nothing_stays_and_by_very_much_is_the_mean)
{
  const Pixels pixels = random_pixels(6, 8);
  EXPECT_EQ(greatest(blurred(pixels, 0) - pixels), 0);
  EXPECT_EQ(greatest(blurred(pixels, 1e-3) - pixels), 0);
  EXPECT_LT(greatest(blurred(pixels, 1e5) - pixels.mean()), 1e-8);
}

TEST(Filtered, bands_add_up_around_middle_gray)
{
  const Pixels pixels = random_pixels(20, 30);
  const Pixels low = filtered(pixels, Curvature_band::low);
  const Pixels high = filtered(pixels, Curvature_band::high);
  EXPECT_LT(greatest(low - blurred(pixels, 2)), 1e-15);
  EXPECT_LT(greatest(low + high - 0.5 - pixels), 1e-15);
  for (const double amount : {1., 2.5})
    EXPECT_LT(greatest(filtered(pixels, Curvature_band::unsharp, amount) - pixels -
                       amount * (high - 0.5)),
              1e-14);
}

TEST(Filtered, keeps_waves_as_the_transform_of_the_gauss_function_says)
{
  const double radius = 2, k = 2 * cgp_test::pi / 16;  // per pixel
  Pixels wave(5, 160);
  for (int c = 0; c < 160; ++c) wave.col(c) = std::sin(k * c);
  const double kept = std::exp(-radius * radius * k * k / 2);
  const Pixels low = filtered(wave, Curvature_band::low);
  EXPECT_LT(greatest((low - kept * wave).middleCols(20, 120)), 2e-6);
  const Pixels high = filtered(wave, Curvature_band::high) - 0.5;
  EXPECT_LT(greatest((high - (1 - kept) * wave).middleCols(20, 120)), 2e-6);
}

TEST(Blurred, refuses_radii_out_of_range)
{
  const Gray_image image(Pixels::Zero(2, 2));
  for (const double radius : {-1., std::nan(""), std::numeric_limits<double>::infinity(), 2e6}) {
    EXPECT_THROW((void)CGP::blurred(image, radius), CGP::Precondition_error);
    EXPECT_THROW((void)CGP::filtered(image, Curvature_band::low, radius), CGP::Precondition_error);
  }
}

}  // namespace cgp_test::image_filters_tests
