// Tests include/Conformal_geometry_processing/surfaces/delaunay_surface.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/surfaces/delaunay_surface.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/mesh_tools.h"

namespace cgp_test::delaunay_surface_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Delaunay_meridian, goes_from_bulge_to_neck_and_back_in_one_period)
{
  for (const double neck : {.3, -.2, 1., .01, -1e-4, 1e-8}) {
    const CGP::internal::Delaunay_meridian meridian(neck, 1);
    const Eigen::Matrix2Xd p = meridian.points(10, 11);
    EXPECT_NEAR(p(0, 0), 1, 1e-15) << neck;
    EXPECT_NEAR(p(0, 5), std::abs(neck), 1e-14) << neck;
    EXPECT_NEAR(p(0, 10), 1, 1e-15) << neck;
    EXPECT_NEAR(p(1, 10), 2 * p(1, 5), 1e-14) << neck;
  }
}

// A focus of an ellipse that rolls on the axis draws it, and one turn is one period.
TEST(Delaunay_meridian, of_an_unduloid_is_as_high_as_an_ellipse_is_round)
{
  for (const double neck : {.9, .25, .01, 1e-4}) {
    const double bulge = 1.1, a = (bulge + neck) / 2, b = std::sqrt(bulge * neck);
    double perimeter = 0;
    const int n = 200000;
    for (int i = 0; i < n; ++i) {
      const double t = 2 * pi * i / n;
      perimeter += std::hypot(a * std::sin(t), b * std::cos(t)) * 2 * pi / n;
    }
    EXPECT_NEAR(CGP::internal::Delaunay_meridian(neck, bulge).points(4, 5)(1, 4), perimeter, 1e-12)
        << neck;
  }
}

// The force along the axis is constant, and the parameter is conformal.
TEST(Delaunay_meridian, solves_its_equations)
{
  for (const double neck : {.4, -.4, .01, -1e-3}) {
    const CGP::internal::Delaunay_meridian meridian(neck, 1);
    const double H = meridian.mean_curvature(), c = H * neck;
    const int n = 20000;
    const Eigen::Matrix2Xd p = meridian.points(n, 2 * n);
    const double h = meridian.period() / n;
    double greatest = 0;
    for (int i = 1; i + 1 < p.cols(); ++i) {
      const Eigen::Vector2d d = (p.col(i + 1) - p.col(i - 1)) / (2 * h);
      const double x = p(0, i);
      greatest = std::max({greatest, std::abs(d.y() - c - H * x * x), std::abs(d.norm() - x)});
    }
    EXPECT_LT(greatest, 10 * h * h) << neck;
  }
}

TEST(Delaunay_meridian, of_a_nodoid_turns_back_at_the_neck)
{
  const Eigen::Matrix2Xd p = CGP::internal::Delaunay_meridian(-.5, 1).points(100, 101);
  EXPECT_GT(p(1, 1), p(1, 0));
  EXPECT_LT(p(1, 51), p(1, 50));
}

TEST(Delaunay_surface, of_two_equal_radii_is_the_cylinder)
{
  const CGP::internal::Delaunay_meridian meridian(2, 2);
  EXPECT_NEAR(meridian.mean_curvature(), .25, 1e-15);
  EXPECT_NEAR(meridian.period(), 2 * pi, 1e-14);
  const Points p = CGP::delaunay_surface(2, 2, 8, 6).positions();
  EXPECT_LT((p.topRows(2).colwise().norm().array() - 2).abs().maxCoeff(), 1e-14);
  EXPECT_NEAR(p.row(2).maxCoeff(), 4 * pi, 1e-12);
}

TEST(Delaunay_surface, is_an_annulus_of_constant_mean_curvature_up_to_second_order)
{
  for (const double neck : {.4, .8, -.4}) {
    const double expected = 1 / (1 + neck);
    std::vector<double> h, errors;
    for (const int n : {24, 48, 96}) {
      const Mesh_view mesh = CGP::delaunay_surface(neck, 1, n, n, 2);
      EXPECT_NO_THROW(CGP::require_surface(mesh, "test"));
      EXPECT_EQ(CGP::boundary_loops(mesh).size(), 2U);
      h.push_back(1. / n);
      const Eigen::ArrayXd H = CGP::mean_curvature(mesh);
      errors.push_back((H / expected - 1).abs().maxCoeff());
    }
    EXPECT_NEAR(slope(h, errors), 2, .2) << neck;
    EXPECT_LT(errors.back(), .02) << neck;
  }
}

TEST(Delaunay_surface, refuses_radii_and_grids_that_make_none)
{
  EXPECT_THROW((void)CGP::internal::Delaunay_meridian(0, 1), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::internal::Delaunay_meridian(2, 1), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::internal::Delaunay_meridian(-1, 1), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::internal::Delaunay_meridian(.5, NAN), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::delaunay_surface(.5, 1, 2, 8), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::delaunay_surface(.5, 1, 8, 0), CGP::Precondition_error);
  EXPECT_THROW((void)CGP::delaunay_surface(.5, 1, 8, 8, 0), CGP::Precondition_error);
}

}  // namespace cgp_test::delaunay_surface_tests
