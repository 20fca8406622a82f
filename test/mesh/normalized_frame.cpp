// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

#include <cmath>
#include <limits>

namespace cgp_test::normalized_frame_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::Normalized_frame;

TEST(Normalized_frame, centres_the_bounding_box)
{
  const Points p = points({{1, 2, 3}, {5, 2, -1}, {2, 8, 0}});
  EXPECT_EQ(Normalized_frame(p).center(), Eigen::Vector3d(3, 5, 1));
}

TEST(Normalized_frame, has_the_power_of_two_below_the_half_diagonal_as_unit)
{
  // Half diagonals 13, 16, and just below 16.
  EXPECT_EQ(Normalized_frame(points({{0, 0, 0}, {6, 8, 24}})).unit(), 8);
  EXPECT_EQ(Normalized_frame(points({{0, 0, 0}, {32, 0, 0}})).unit(), 16);
  EXPECT_EQ(Normalized_frame(points({{0, 0, 0}, {std::nextafter(32., 0.), 0, 0}})).unit(), 8);
}

TEST(Normalized_frame, brings_every_surface_to_a_half_diagonal_between_one_and_two)
{
  for (double size : {1e-300, 1e-150, 1e-3, 1., 7., 1e20, 1e150, 1e300}) {
    const Points p = size * perturbed(icosphere(1), .2).positions();
    const Points q = Normalized_frame(p).to_frame(p);
    const Eigen::Vector3d low = q.rowwise().minCoeff(), high = q.rowwise().maxCoeff();
    const double radius = (high - low).norm() / 2;
    EXPECT_GE(radius, 1 - 1e-15) << size;
    EXPECT_LT(radius, 2 + 1e-15) << size;
    EXPECT_LT((low + high).norm(), 1e-14) << size;
  }
}

TEST(Normalized_frame, gives_the_same_bits_to_surfaces_that_differ_by_a_power_of_two)
{
  const Points p = perturbed(icosphere(1), .2).positions();
  const Points wanted = Normalized_frame(p).to_frame(p);
  for (int exponent : {-900, -40, 3, 900}) {
    const Points q = std::ldexp(1., exponent) * p;
    const Normalized_frame frame(q);
    EXPECT_EQ(frame.to_frame(q), wanted) << exponent;
    EXPECT_EQ(frame.unit(), std::ldexp(Normalized_frame(p).unit(), exponent));
  }
}

TEST(Normalized_frame, comes_back_to_the_same_bits_where_the_centre_is_the_origin)
{
  Points p = perturbed(icosphere(1), .2).positions();
  p.col(0).setConstant(-2);
  p.col(1).setConstant(2);
  for (double size : {1e-300, 1., 1e300}) {
    const Normalized_frame frame(size * p);
    EXPECT_EQ(frame.from_frame(frame.to_frame(size * p)), size * p) << size;
  }
}

TEST(Normalized_frame, comes_back_to_the_same_bits_from_a_million_diameters_away)
{
  Points p = perturbed(icosphere(2), .2).positions();
  p.colwise() += Eigen::Vector3d(2e6, -3e6, 1e6);
  const Normalized_frame frame(p);
  EXPECT_EQ(frame.from_frame(frame.to_frame(p)), p);
}

TEST(Normalized_frame, comes_back_within_a_rounding_of_the_diagonal_from_anywhere)
{
  for (double offset : {.1, 1., 33.}) {
    const Points p = (perturbed(icosphere(2), .2).positions().array() + offset).matrix();
    const Normalized_frame frame(p);
    EXPECT_LT((frame.from_frame(frame.to_frame(p)) - p).cwiseAbs().maxCoeff(),
              1e-15 * (2 + offset));
  }
}

TEST(Normalized_frame, leaves_the_scale_of_a_single_point)
{
  const Points p = points({{5, 6, 7}});
  const Normalized_frame frame(p);
  EXPECT_EQ(frame.unit(), 1);
  EXPECT_EQ(frame.to_frame(p), Points::Zero(3, 1));
}

TEST(Normalized_frame, reaches_to_the_ends_of_double_precision)
{
  const double largest = std::numeric_limits<double>::max();
  const Points p = points({{-largest, 0, 0}, {largest, 0, 0}, {0, largest, 0}});
  EXPECT_TRUE(Normalized_frame(p).to_frame(p).allFinite());
  const Points q = points({{largest / 2, 0, 0}, {largest, 0, 0}});
  EXPECT_TRUE(Normalized_frame(q).to_frame(q).allFinite());
}

TEST(In_own_frame, is_of_moderate_size_around_the_origin)
{
  const Mesh_view mesh = mapped(perturbed(icosphere(1), .2), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p + Eigen::Vector3d(5, 0, -3));
  });
  const Mesh_view wanted = CGP::internal::in_own_frame(mesh);
  EXPECT_EQ(wanted.corners(), mesh.corners());
  EXPECT_LT(wanted.positions().cwiseAbs().maxCoeff(), 2);
  EXPECT_GT(wanted.positions().cwiseAbs().maxCoeff(), .5);
  for (const int exponent : {-900, 900})
    EXPECT_EQ(CGP::internal::in_own_frame(scaled(mesh, std::ldexp(1., exponent))).positions(),
              wanted.positions());
}

}  // namespace cgp_test::normalized_frame_tests
