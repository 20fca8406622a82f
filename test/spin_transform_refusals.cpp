// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin_transform.h
// Tests include/Conformal_geometry_processing/core/write_points.h
// Tests include/Conformal_geometry_processing/spin/Spin_report.h
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "spin_transform_checks.h"
#include "support/thin_faces.h"

namespace cgp_test::spin_transform_refusals_tests {

namespace params = CGP::parameters;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Vertex = Surface::Vertex_index;
using Function = std::function<double(Vertex)>;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

boost::function_property_map<Function, Vertex> map_of(Function function)
{
  return boost::function_property_map<Function, Vertex>(std::move(function));
}

/// Returns the message of the exception, empty if there is none
std::string refusal(
    const Mesh_view& view, Function rho = [](Vertex) { return 0.; })
{
  Surface mesh = to_cgal_mesh<Surface>(view);
  try {
    (void)CGP::spin_transform(mesh, map_of(std::move(rho)));
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(error.function(), "spin_transform");
    return error.message();
  }
  return "";
}

Mesh_view with_point(const Mesh_view& mesh, int v, const Eigen::Vector3d& p)
{
  Points points = mesh.positions();
  points.col(v) = p;
  return {points, mesh.corners()};
}

/// A writable map that throws once, when it is written for the n-th time. Stores its values.
template <class Value>
struct Throwing_map {
  using key_type = Vertex;
  using value_type = Value;
  using reference = Value&;
  using category = boost::lvalue_property_map_tag;

  std::shared_ptr<std::vector<Value>> values;
  std::shared_ptr<int> writes_left;

  friend Value& get(const Throwing_map& m, Vertex v) { return (*m.values)[v]; }
  friend void put(const Throwing_map& m, Vertex v, const Value& value)
  {
    if ((*m.writes_left)-- == 0) throw std::runtime_error("full");
    (*m.values)[v] = value;
  }
};

struct Throwing_visitor : CGP::Spin_visitor {
  void on_iteration(const CGP::Eigensolver_progress& progress)
  {
    if (progress.iteration == 1) throw std::runtime_error("visitor");
  }
};

class Spin_transform_that_fails : public testing::Test {
 protected:
  void expect_untouched() const { EXPECT_EQ(view_of(mesh).positions(), before.positions()); }

  Surface mesh = to_cgal_mesh<Surface>(icosphere(1));
  const Mesh_view before = view_of(mesh);
  const Function function = [this](Vertex v) {
    return rho_of_section_3(before.position(static_cast<int>(v)));
  };
};

TEST(Spin_transform_of_unsuitable_input, refuses_surfaces_it_cannot_transform)
{
  EXPECT_EQ(refusal(Mesh_view(Points(3, 0), Corners())), "the mesh has no faces");
  EXPECT_EQ(refusal(disjoint_union(icosahedron(), tetrahedron(), {9, 0, 0})),
            "the mesh has 2 components, the second begins at vertex 12; one component is needed, "
            "transform each alone");
  EXPECT_EQ(refusal(with_point(icosahedron(), 4, {0, not_a_number, 0})),
            "1 vertex with a coordinate that is not finite, the first is vertex 4; finite "
            "coordinates are needed");
  EXPECT_NE(refusal(with_point(icosahedron(), 4, icosahedron().position(5)))
                .find("2 faces of area zero, the first is face"),
            std::string::npos);
}

TEST(Spin_transform_of_unsuitable_input, refuses_values_of_rho_that_are_not_finite)
{
  EXPECT_EQ(refusal(icosahedron(), [](Vertex v) { return v == Vertex(7) ? not_a_number : 0.; }),
            "1 value of rho not finite, the first is vertex 7; finite values are needed");
}

TEST_F(Spin_transform_that_fails, because_of_rho_leaves_the_mesh_as_it_was)
{
  const auto rho = map_of([](Vertex v) -> double {
    if (v == Vertex(20)) throw std::runtime_error("rho");
    return 0;
  });
  EXPECT_THROW((void)CGP::spin_transform(mesh, rho), std::runtime_error);
  expect_untouched();
}

TEST_F(Spin_transform_that_fails, because_of_the_visitor_leaves_the_mesh_as_it_was)
{
  Throwing_visitor visitor;
  EXPECT_THROW(
      (void)CGP::spin_transform(mesh, map_of(function), params::visitor(std::ref(visitor))),
      std::runtime_error);
  expect_untouched();
}

TEST_F(Spin_transform_that_fails, because_of_the_spin_map_leaves_the_points_as_they_were)
{
  using Map = Throwing_map<Quaternion<double>>;
  const Map lambda{std::make_shared<std::vector<Quaternion<double>>>(42),
                   std::make_shared<int>(10)};
  EXPECT_THROW((void)CGP::spin_transform(mesh, map_of(function), params::vertex_spin_map(lambda)),
               std::runtime_error);
  expect_untouched();
}

TEST_F(Spin_transform_that_fails, because_of_the_points_puts_those_back_that_it_wrote)
{
  const Throwing_map<Point> points{std::make_shared<std::vector<Point>>(),
                                   std::make_shared<int>(10)};
  for (const Vertex v : vertices(mesh)) points.values->push_back(mesh.point(v));
  const std::vector<Point> old = *points.values;
  EXPECT_THROW((void)CGP::spin_transform(mesh, map_of(function), params::vertex_point_map(points)),
               std::runtime_error);
  EXPECT_EQ(*points.values, old);
  expect_untouched();
}

TEST_F(Spin_transform_that_fails, because_of_the_output_map_leaves_the_mesh_as_it_was)
{
  const Throwing_map<Point> output{std::make_shared<std::vector<Point>>(42),
                                   std::make_shared<int>(10)};
  EXPECT_THROW(
      (void)CGP::spin_transform(mesh, map_of(function), params::output_vertex_point_map(output)),
      std::runtime_error);
  expect_untouched();
}

TEST(Spin_visitor, watches_without_a_word)
{
  CGP::Spin_visitor visitor;
  visitor.on_iteration({0, 1, 2});
  EXPECT_TRUE(visitor.go_further());
}

TEST(Spin_transform_with_mollification, takes_the_faces_of_area_zero_that_are_refused_without)
{
  const Mesh_view view = spoilt(icosphere(2));
  EXPECT_NE(refusal(view).find("of area zero"), std::string::npos);
  Surface mesh = to_cgal_mesh<Surface>(view);
  const Eigen::VectorXd values = rho_of_section_3_on_vertices(view);
  const auto rho = map_of([&](Vertex v) { return values[static_cast<int>(v)]; });
  const CGP::Spin_report report = CGP::spin_transform(mesh, rho, unbounded().mollification(1e-6));
  EXPECT_TRUE(report);
  CGP::Spin_transformation_options options;
  options.mollification = 1e-6;
  const CGP::Spin_result expected =
      CGP::Spin_transformation(view, options).transform(Curvature_potential::on_vertices(values));
  EXPECT_NEAR(report.eigenvalue, expected.report.eigenvalue, 1e-9);
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.positions), 1e-9);
}

TEST(Spin_transform_with_mollification, takes_handles_and_boundaries)
{
  for (const Mesh_view& view : {spoilt(btorus(16)), spoilt(without_face(icosphere(2), 0))}) {
    Surface mesh = to_cgal_mesh<Surface>(view);
    const Eigen::VectorXd values = rho_of_section_3_on_vertices(view);
    const auto rho = map_of([&](Vertex v) { return values[static_cast<int>(v)] / 4; });
    const CGP::Spin_report report = CGP::spin_transform(mesh, rho, unbounded().mollification(1e-6));
    EXPECT_TRUE(report);
    EXPECT_GT(report.mollification.thin_faces, 0);
    CGP::Spin_transformation_options options;
    options.mollification = 1e-6;
    const CGP::Spin_result expected = CGP::Spin_transformation(view, options)
                                          .transform(Curvature_potential::on_vertices(values / 4));
    EXPECT_NEAR(report.missing_share, expected.report.missing_share, 1e-9);
    EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.positions), 1e-9);
  }
}

}  // namespace cgp_test::spin_transform_refusals_tests
