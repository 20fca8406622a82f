// Tests examples/conformal/repair/ears_of.cpp examples/conformal/repair/Dents.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/repair/ears_of.h"

#include "conformal/repair/Dents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace cgp_test::ears_of_tests {

using namespace conformal;

/// (1 + depth cos(teeth angle)) e^{i angle}: round if the depth is 0, else a star
Plane_polygon star(int corners, double depth, int teeth)
{
  Plane_polygon points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::acos(-1.) * i / corners;
    points.push_back((1 + depth * std::cos(teeth * angle)) *
                     Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

/// a star with a hole in its middle, joined to it by a bridge
Plane_polygon ring(int corners, double depth)
{
  Plane_polygon points = star(corners, depth, 5), hole = star(corners, 0, 1);
  points.push_back(points[0]);
  for (int i = corners; i >= 0; --i)
    points.push_back(.3 * hole[static_cast<std::size_t>(i % corners)]);
  return points;
}

double area(const Plane_polygon& points)
{
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    twice += twice_area(points[0], points[i], points[(i + 1) % points.size()]);
  return twice / 2;
}

class Ears : public ::testing::TestWithParam<std::function<Plane_polygon()>> {};

TEST_P(Ears, are_the_polygon_once)
{
  const Plane_polygon points = GetParam()();
  const auto ears = ears_of(points);
  ASSERT_EQ(ears.size(), points.size() - 2);
  double sum = 0;
  std::vector<int> valence(points.size(), 0);
  for (const auto& [a, b, c] : ears) {
    const double own = twice_area(points[a], points[b], points[c]) / 2;
    EXPECT_GT(own, 0);
    sum += own;
    for (const std::size_t v : {a, b, c}) ++valence[v];
  }
  EXPECT_NEAR(sum, area(points), 1e-10);
  // A fan would be thin, and slow to work on.
  EXPECT_LT(*std::max_element(valence.begin(), valence.end()), 200);
}

// In so many corners, cost that is quadratic would be noticed.
INSTANTIATE_TEST_SUITE_P(
    Polygons, Ears,
    ::testing::Values([] { return ring(3, 0); }, [] { return ring(40, .5); },
                      [] { return ring(300, .5); }, [] { return star(50, 0, 1); },
                      [] { return star(1000, .5, 7); }, [] { return star(3000, .3, 1000); },
                      [] { return star(200000, 0, 1); }, [] { return star(50000, .4, 2000); }));

TEST(Ears_of, of_polygons_that_cross_themselves_end)
{
  Plane_polygon points = star(3000, .5, 3);
  for (std::size_t i = 0; i + 1 < points.size(); i += 3) std::swap(points[i], points[i / 2]);
  EXPECT_EQ(ears_of(points).size(), points.size() - 2);
  EXPECT_EQ(ears_of(Plane_polygon(1000, Eigen::Vector2d(1, 2))).size(), 998u);
}

}  // namespace cgp_test::ears_of_tests
