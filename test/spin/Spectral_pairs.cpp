// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin/Spectral_pairs.h
// Tests include/Conformal_geometry_processing/spin/spectral_subspace_size.h
#include <Conformal_geometry_processing/spin/Spectral_pairs.h>
#include <Conformal_geometry_processing/spin/spectral_subspace_size.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace cgp_test::spectral_pairs_tests {

namespace internal = Conformal_geometry_processing::internal;

/// quotients .1, -.5, 1, -2 with the squared errors .01, .04, .02, .5
internal::Spectral_pairs four_pairs(double reach)
{
  internal::Spectral_pairs p;
  p.quotients = Eigen::Vector4d(.1, -.5, 1, -2);
  p.energies = p.quotients.array().square() + Eigen::Array4d(.01, .04, .02, .5);
  p.squared_images = Eigen::Vector4d::Constant(9);
  p.of_pencil = p.residuals = Eigen::Vector4d::Zero();
  p.vectors.resize(2, 4);
  p.reach = reach;
  return p;
}

TEST(Spectral_pairs, tell_the_greatest_squared_error_of_the_first)
{
  EXPECT_NEAR(internal::squared_error(four_pairs(9), 1), .01, 1e-15);
  EXPECT_NEAR(internal::squared_error(four_pairs(9), 3), .04, 1e-15);
  EXPECT_NEAR(internal::squared_error(four_pairs(9), 9), .5, 1e-15);
  internal::Spectral_pairs exact = four_pairs(9);
  exact.energies = exact.quotients.array().square() - 1e-3;  // up to rounding and lumping
  EXPECT_EQ(internal::squared_error(exact, 4), 0);
}

TEST(Spectral_pairs, are_complete_as_far_as_their_errors_leave_of_the_reach)
{
  EXPECT_NEAR(internal::needed_reach(four_pairs(9), 3), 1.08, 1e-15);
  EXPECT_TRUE(internal::is_window_complete(four_pairs(1.09), 3));
  EXPECT_FALSE(internal::is_window_complete(four_pairs(1.07), 3));
  EXPECT_FALSE(internal::is_window_complete(four_pairs(9), 5));
  EXPECT_NEAR(internal::complete_radius(four_pairs(2.08), 4), std::sqrt(2.), 1e-12);
  EXPECT_NEAR(internal::complete_radius(four_pairs(.5), 4), std::sqrt(.42), 1e-12);
  EXPECT_EQ(internal::complete_radius(four_pairs(.02), 4), 0);
}

TEST(Spectral_pairs, are_not_complete_beyond_the_first_that_is_not_listed)
{
  EXPECT_EQ(internal::complete_radius(four_pairs(9), 3), 2);
  EXPECT_NEAR(internal::complete_radius(four_pairs(9), 4), std::sqrt(8.), 1e-12);
  const double all = std::numeric_limits<double>::infinity();
  EXPECT_EQ(internal::complete_radius(four_pairs(all), 4), all);
}

TEST(Spectral_pairs, are_those_that_the_mesh_resolves_nearest_first)
{
  internal::Spectral_pairs p = four_pairs(9);
  p.quotients = Eigen::Vector4d(-2, .1, 1, -.5);
  p.energies = Eigen::Vector4d(4.5, .02, 5, .29);
  p.squared_images = Eigen::Vector4d(9, 0.03, 7.9, 1);  // the third errs by 4 > 7.9 / 2
  p.residuals = Eigen::Vector4d(0, 1, 2, 3);
  const internal::Spectral_pairs r = internal::resolved_nearest_first(p);
  EXPECT_EQ(r.quotients, Eigen::Vector3d(.1, -.5, -2));
  EXPECT_EQ(r.residuals, Eigen::Vector3d(1, 3, 0));
  EXPECT_EQ(r.reach, 5);
  EXPECT_TRUE(r.is_limited_by_mesh);
  const internal::Spectral_pairs again = internal::resolved_nearest_first(r);
  EXPECT_EQ(again.reach, 5);
  EXPECT_FALSE(again.is_limited_by_mesh);
}

TEST(Spectral_pairs, resolve_what_does_not_oscillate_from_edge_to_edge_though_it_errs)
{
  internal::Spectral_pairs p = four_pairs(9);
  p.squared_images[0] = p.energies[0] = 1;  // and the quotient .1
  EXPECT_EQ(internal::resolved_nearest_first(p).size(), 3);
  p.slow_energy = 1;
  EXPECT_EQ(internal::resolved_nearest_first(p).size(), 4);
}

// On a mesh whose vertices have two colors, what changes its sign with them has averages of zero.
TEST(Spectral_pairs, do_not_resolve_what_averaging_cancels)
{
  internal::Spectral_pairs p = four_pairs(9);
  p.quotients[3] = -1e10;
  const internal::Spectral_pairs r = internal::resolved_nearest_first(p);
  EXPECT_EQ(r.size(), 3);
  EXPECT_EQ(r.reach, p.energies[3]);
  EXPECT_TRUE(r.is_limited_by_mesh);
}

TEST(Spectral_pairs, resolve_constants_whose_image_is_zero)
{
  internal::Spectral_pairs p = four_pairs(9);
  p.energies[2] = 1 + 1e-12;
  p.squared_images[2] = 0;  // with a slow energy of zero too
  EXPECT_EQ(internal::resolved_nearest_first(p).size(), 4);
}

TEST(Spectral_subspace_size, exceeds_the_count_and_grows_with_the_missing_energy)
{
  EXPECT_EQ(internal::first_subspace_size(12), 22);
  EXPECT_EQ(internal::largest_subspace_size(12), 140);
  EXPECT_EQ(internal::next_subspace_size(20, 99, four_pairs(1.08 / 1.5), 3), 33);
  EXPECT_EQ(internal::next_subspace_size(20, 99, four_pairs(1), 3), 25);
  EXPECT_EQ(internal::next_subspace_size(20, 99, four_pairs(.1), 3), 40);
  EXPECT_EQ(internal::next_subspace_size(20, 99, four_pairs(9), 5), 40);  // too few
  EXPECT_EQ(internal::next_subspace_size(20, 30, four_pairs(9), 5), 30);
}

}  // namespace cgp_test::spectral_pairs_tests
