// Tests include/Conformal_geometry_processing/isometric_curve_flow.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/isometric_curve_flow.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include "support/plane_curves.h"

#include <list>
#include <stdexcept>
#include <utility>
#include <vector>

namespace cgp_test::isometric_curve_flow_tests {

namespace CGP = Conformal_geometry_processing;

template <class Kernel>
std::vector<typename Kernel::Point_2> points_of(const Curve& curve)
{
  std::vector<typename Kernel::Point_2> points;
  for (const auto& p : curve.colwise()) points.emplace_back(p.x(), p.y());
  return points;
}

template <class Range>
Curve curve_of(const Range& points)
{
  Curve curve(2, static_cast<Eigen::Index>(points.size()));
  Eigen::Index i = 0;
  for (const auto& p : points)
    curve.col(i++) = Eigen::Vector2d(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
  return curve;
}

/// The result of the class
Curve expected(const Curve& curve, double tau, int steps)
{
  CGP::Curve_flow_options options;
  options.time_step = tau;
  CGP::Isometric_curve_flow flow(curve, options);
  for (int i = 0; i < steps; ++i) (void)flow.step();
  return flow.points();
}

const auto three_steps = CGP::parameters::time_step(.3).number_of_iterations(3u);

template <class Kernel>
class Curves_of_kernel : public testing::Test {};
using Kernels = testing::Types<CGAL::Simple_cartesian<double>,
                               CGAL::Exact_predicates_inexact_constructions_kernel,
                               CGAL::Exact_predicates_exact_constructions_kernel>;
TYPED_TEST_SUITE(Curves_of_kernel, Kernels);

TYPED_TEST(Curves_of_kernel, flow)
{
  auto points = points_of<TypeParam>(flower(60));
  const CGP::Curve_flow_report report = CGP::isometric_curve_flow(points, three_steps);
  EXPECT_EQ(report.steps.size(), 3u);
  EXPECT_EQ(report.turning_number, 1);
  EXPECT_EQ(curve_of(points), expected(flower(60), .3, 3));
}

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_2;

TEST(Isometric_curve_flow_of_ranges, without_parameters_makes_a_circle)
{
  auto points = points_of<Kernel>(flower(200));
  const CGP::Curve_flow_report report = CGP::isometric_curve_flow(points);
  EXPECT_TRUE(report.converged());
  EXPECT_NEAR(energy_times_length(curve_of(points)), 4 * pi * pi, 1e-5);
  EXPECT_LT(distortion(flower(200), curve_of(points)), 1e-12);
}

TEST(Isometric_curve_flow_of_ranges, takes_the_container_of_a_polygon)
{
  const auto points = points_of<Kernel>(rose(60));
  CGAL::Polygon_2<Kernel> polygon(points.begin(), points.end());
  (void)CGP::isometric_curve_flow(polygon.container(), three_steps);
  EXPECT_EQ(curve_of(polygon.container()), expected(rose(60), .3, 3));
}

TEST(Isometric_curve_flow_of_ranges, takes_a_list_of_pairs_with_a_point_map)
{
  std::list<std::pair<int, Point>> vertices;
  for (const Point& p : points_of<Kernel>(figure_eight(60))) vertices.emplace_back(7, p);
  const CGAL::Second_of_pair_property_map<std::pair<int, Point>> map;
  (void)CGP::isometric_curve_flow(vertices, CGAL::parameters::point_map(map) | three_steps);
  std::vector<Point> points;
  for (const auto& [number, point] : vertices) points.push_back(point);
  EXPECT_EQ(curve_of(points), expected(figure_eight(60), .3, 3));
}

TEST(Isometric_curve_flow_of_ranges, takes_indices_of_points)
{
  auto points = points_of<Kernel>(flower(60));
  std::vector<std::size_t> order;
  for (std::size_t i = 60; i-- > 0;) order.push_back(i);
  const std::vector<std::size_t> indices = order;
  (void)CGP::isometric_curve_flow(indices,
                                  CGP::parameters::point_map(CGAL::make_property_map(points))
                                      .time_step(.3)
                                      .number_of_iterations(3));
  const Curve reversed = flower(60).rowwise().reverse();
  EXPECT_EQ(curve_of(points).rowwise().reverse(), expected(reversed, .3, 3));
}

TEST(Isometric_curve_flow_of_ranges, flows_open_curves)
{
  auto points = points_of<Kernel>(flower(60).leftCols(40));
  const CGP::Curve_flow_report report = CGP::isometric_curve_flow(
      points,
      CGP::parameters::is_closed(false).time_step(.25).number_of_iterations(1).tolerance(0.));
  EXPECT_NEAR(report.energy / report.initial_energy, .25, 1e-12);
  EXPECT_EQ(report.turning_number, 0);
}

struct Stops_after_two : CGP::Curve_flow_visitor {
  bool go_further() { return steps < 2; }
  void on_step_end(const CGP::Curve_step_report&, const Curve&) { ++steps; }
  int steps = 0;
};

TEST(Isometric_curve_flow_of_ranges, writes_the_last_complete_step_when_stopped)
{
  auto points = points_of<Kernel>(flower(60));
  Stops_after_two visitor;
  const CGP::Curve_flow_report report =
      CGP::isometric_curve_flow(points, CGP::parameters::time_step(.3).visitor(std::ref(visitor)));
  EXPECT_EQ(report.stop, CGP::Curve_step_report::Stop::cancelled);
  EXPECT_EQ(curve_of(points), expected(flower(60), .3, 2));
}

struct Throws : CGP::Curve_flow_visitor {
  void on_step_end(const CGP::Curve_step_report&, const Curve&) { throw std::runtime_error("no"); }
};

TEST(Isometric_curve_flow_of_ranges, leaves_the_points_alone_on_failure)
{
  auto points = points_of<Kernel>(flower(60));
  const auto before = points;
  Throws visitor;
  EXPECT_THROW((void)CGP::isometric_curve_flow(points, CGP::parameters::visitor(std::ref(visitor))),
               std::runtime_error);
  EXPECT_THROW((void)CGP::isometric_curve_flow(points, CGP::parameters::time_step(1.)),
               CGP::Precondition_error);
  EXPECT_EQ(points, before);
  points[7] = points[8];
  const auto bad = points;
  try {
    (void)CGP::isometric_curve_flow(points);
    ADD_FAILURE() << "accepted";
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(error.function(), "isometric_curve_flow");
    EXPECT_NE(error.message().find("points 7 and 8"), std::string::npos) << error.what();
  }
  EXPECT_EQ(points, bad);
}

/// throws when the twentieth point is written
struct Failing_map {
  using key_type = Point;
  using value_type = Point;
  using reference = const Point&;
  using category = boost::read_write_property_map_tag;
  int* writes;
};
const Point& get(const Failing_map&, const Point& p)
{
  return p;
}
void put(const Failing_map& map, Point& p, const Point& q)
{
  if (++*map.writes == 20) throw std::runtime_error("full");
  p = q;
}

TEST(Isometric_curve_flow_of_ranges, restores_the_points_when_their_map_throws)
{
  auto points = points_of<Kernel>(flower(60));
  const auto before = points;
  int writes = 0;
  EXPECT_THROW(
      (void)CGP::isometric_curve_flow(points, CGP::parameters::point_map(Failing_map{&writes})),
      std::runtime_error);
  EXPECT_EQ(points, before);
}

/// points without a kernel, in units of a thousandth
struct Plain_point {
  double thousand_x, thousand_y;
};
struct Plain_traits {
  using FT = double;
  using Point_2 = Plain_point;
  struct Compute_x_2 {
    double operator()(const Plain_point& p) const { return p.thousand_x / 1000; }
  };
  struct Compute_y_2 {
    double operator()(const Plain_point& p) const { return p.thousand_y / 1000; }
  };
  struct Construct_point_2 {
    Plain_point operator()(double x, double y) const { return {1000 * x, 1000 * y}; }
  };
  Compute_x_2 compute_x_2_object() const { return {}; }
  Compute_y_2 compute_y_2_object() const { return {}; }
  Construct_point_2 construct_point_2_object() const { return {}; }
};

TEST(Isometric_curve_flow_of_ranges, takes_points_of_ones_own_with_their_traits)
{
  std::vector<Plain_point> points;
  const Curve curve = flower(60);
  for (const auto& p : curve.colwise()) points.push_back({1000 * p.x(), 1000 * p.y()});
  (void)CGP::isometric_curve_flow(
      points, CGP::parameters::geom_traits(Plain_traits()).time_step(.3).number_of_iterations(3));
  const Curve result = expected(flower(60), .3, 3);
  for (Eigen::Index i = 0; i < 60; ++i)
    EXPECT_NEAR(points[static_cast<std::size_t>(i)].thousand_x, 1000 * result(0, i), 1e-9);
}

}  // namespace cgp_test::isometric_curve_flow_tests
