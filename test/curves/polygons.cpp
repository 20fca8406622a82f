// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/polygons.h>

#include <gtest/gtest.h>

#include "support/plane_curves.h"

#include <limits>

namespace cgp_test::polygons_tests {

namespace CGP = Conformal_geometry_processing;

Curve rectangle()
{
  Curve points(2, 4);
  points << 0, 3, 3, 0,  //
      0, 0, 1, 1;
  return points;
}

TEST(Polygon_lengths, of_a_rectangle)
{
  const CGP::internal::Polygon_lengths closed(rectangle(), true), open(rectangle(), false);
  EXPECT_EQ(closed.edges(), Eigen::Vector4d(3, 1, 3, 1));
  EXPECT_EQ(closed.duals(), Eigen::Vector4d(2, 2, 2, 2));
  EXPECT_EQ(closed.total(), 8);
  EXPECT_EQ(open.edges(), Eigen::Vector3d(3, 1, 3));
  EXPECT_EQ(open.duals(), Eigen::Vector4d(1.5, 2, 2, 1.5));
  EXPECT_EQ(open.total(), 7);
}

TEST(Polygon_lengths, distortion_is_that_of_the_worst_edge)
{
  const CGP::internal::Polygon_lengths closed(rectangle(), true), open(rectangle(), false);
  Curve stretched = rectangle();
  stretched(0, 0) = -0.6;
  stretched(0, 3) = -0.3;
  EXPECT_NEAR(CGP::length_distortion(stretched, closed), 0.2, 1e-15);
  EXPECT_NEAR(CGP::length_distortion(stretched, open), 0.2, 1e-15);
  stretched(0, 0) = 0;
  stretched(1, 3) = 0.5;  // the edge 2-3 becomes longer, the closing one half as long
  EXPECT_NEAR(CGP::length_distortion(stretched, open), std::hypot(3.3, 0.5) / 3 - 1, 1e-15);
  EXPECT_NEAR(CGP::length_distortion(stretched, closed), 1 - std::hypot(0.3, 0.5), 1e-15);
}

TEST(Turning_angles, of_a_rectangle_are_right_angles_to_the_left)
{
  EXPECT_TRUE(CGP::turning_angles(rectangle(), true).isApproxToConstant(pi / 2, 1e-15));
  const Eigen::VectorXd open = CGP::turning_angles(rectangle(), false);
  EXPECT_EQ(open[0], 0);
  EXPECT_EQ(open[3], 0);
  EXPECT_NEAR(open[1], pi / 2, 1e-15);
  const Curve reversed = rectangle().rowwise().reverse();
  EXPECT_TRUE(CGP::turning_angles(reversed, true).isApproxToConstant(-pi / 2, 1e-15));
}

TEST(Turning_angles, are_those_of_quotients_of_complex_edges)
{
  for (const Curve& curve : {flower(50), figure_eight(61), rose(72)}) {
    const Eigen::VectorXd angles = CGP::turning_angles(curve, true);
    const std::vector<double> expected = angles_of(curve);
    for (Eigen::Index i = 0; i < curve.cols(); ++i)
      EXPECT_NEAR(angles[i], expected[static_cast<std::size_t>(i)], 1e-13);
  }
}

TEST(Turning_number, counts_turns)
{
  const auto turns = [](const Curve& c) {
    return CGP::turning_number(CGP::turning_angles(c, true));
  };
  EXPECT_EQ(turns(flower(200)), 1);
  EXPECT_EQ(turns(figure_eight(200)), 0);
  EXPECT_EQ(turns(limacon(200)), 2);
  EXPECT_EQ(turns(rose(200)), 3);
  EXPECT_EQ(turns(rose(200).rowwise().reverse()), -3);
  const Curve pentagram = sampled(5, [](double t) { return std::polar(1., 2 * t); });
  EXPECT_EQ(turns(pentagram), 2);
}

TEST(Bending_energy, of_regular_polygons_is_four_pi_squared_by_their_length)
{
  for (const int m : {3, 4, 17, 100}) {
    const Curve polygon = sampled(m, [](double t) { return std::polar(2.5, t); });
    const CGP::internal::Polygon_lengths lengths(polygon, true);
    const Eigen::VectorXd kappa = CGP::turning_angles(polygon, true).cwiseQuotient(lengths.duals());
    EXPECT_NEAR(CGP::bending_energy(kappa, lengths) * lengths.total(), 4 * pi * pi, 1e-12) << m;
  }
}

testing::AssertionResult is_refused(const Curve& points, bool is_closed, const std::string& words)
{
  try {
    CGP::require_polygon(points, is_closed, "test");
  } catch (const CGP::Precondition_error& error) {
    if (error.message().find(words) != std::string::npos && error.function() == "test")
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << error.what();
  }
  return testing::AssertionFailure() << "accepted";
}

TEST(Require_polygon, accepts_curves)
{
  for (const Curve& curve : {flower(50), figure_eight(50), Curve(rectangle())}) {
    CGP::require_polygon(curve, true, "test");
    CGP::require_polygon(curve, false, "test");
  }
}

TEST(Require_polygon, refuses_fewer_than_three_points)
{
  EXPECT_TRUE(is_refused(rectangle().leftCols(2), true, "2 points; a curve of three"));
  EXPECT_TRUE(is_refused(rectangle().leftCols(2), false, "2 points; a curve of three"));
  EXPECT_TRUE(is_refused(Curve(2, 0), true, "0 points"));
}

TEST(Require_polygon, refuses_coordinates_that_are_not_finite)
{
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Curve points = rectangle();
    points(1, 2) = bad;
    EXPECT_TRUE(is_refused(points, true,
                           "1 point with a coordinate that is not finite, the first "
                           "is point 2"));
  }
}

TEST(Require_polygon, refuses_points_that_coincide)
{
  Curve points = rectangle();
  points.col(2) = points.col(1);
  EXPECT_TRUE(is_refused(points, true, "the first is points 1 and 2; remove one"));
  Curve repeated(2, 5);
  repeated << rectangle(), Eigen::Vector2d::Zero();
  EXPECT_TRUE(is_refused(repeated, true, "points 4 and 0; leave out the last point"));
  CGP::require_polygon(repeated, false, "test");  // an open curve may return
}

TEST(Require_polygon, refuses_half_turns_and_names_them)
{
  Curve points(2, 4);
  points << 0, 2, 1, 0,  //
      0, 0, 0, 1;
  EXPECT_TRUE(is_refused(points, true,
                         "1 point where the curve goes straight back (a turn by "
                         "+-pi), the first is point 1"));
  EXPECT_TRUE(is_refused(points, false, "point 1"));
  points.col(1).y() = 1e-3;
  CGP::require_polygon(points, true, "test");
}

}  // namespace cgp_test::polygons_tests
