// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin_transform.h
// Tests core/spin_parameters.h, core/spin_parameters.h
#include <Quaternionic_linear_algebra/krylov/inverse_power_method.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/math/quaternion.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <Eigen/Geometry>

#include <array>
#include <functional>

#include "spin_transform_checks.h"

namespace cgp_test::spin_transform_tests {

namespace params = CGP::parameters;
using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
using Vertex = Surface::Vertex_index;

class Spin_transform : public testing::Test {
 protected:
  /// writes lambda into a map of Q
  template <class Q>
  void expect_spins_as()
  {
    Surface copy = mesh;
    auto lambda = copy.add_property_map<Vertex, Q>("lambda").first;
    ASSERT_TRUE(CGP::spin_transform(copy, rho, unbounded().vertex_spin_map(lambda)));
    const auto written = spins(vertices(copy), lambda, before.size_of_vertices());
    EXPECT_LT(greatest_difference(written, expected.lambda), 1e-6);  // also in float
  }

  void expect_untouched() const { EXPECT_EQ(view_of(mesh).positions(), before.positions()); }

  Surface mesh = to_cgal_mesh<Surface>(sphere_to_transform());
  const Mesh_view before = view_of(mesh);
  /// rho as a function, in a readable map
  const std::function<double(Vertex)> function = [this](Vertex v) {
    return rho_of_section_3(before.position(static_cast<int>(v)));
  };
  const boost::function_property_map<std::function<double(Vertex)>, Vertex> rho{function};
  const CGP::Spin_result expected = expected_result(before, rho_on_vertices(before));
};

/// counts, and stops after  iterations
struct Counter : CGP::Spin_visitor {
  explicit Counter(int n) : limit(n) {}
  void on_iteration(const CGP::Eigensolver_progress&) { ++count; }
  bool go_further() { return count < limit; }
  int count = 0, limit;
};

TEST_F(Spin_transform, overwrites_the_points_with_those_of_the_result)
{
  const CGP::Spin_report report = CGP::spin_transform(mesh, rho, unbounded());
  EXPECT_TRUE(report);
  EXPECT_EQ(view_of(mesh).positions(), expected.positions);
  EXPECT_EQ(report.eigenvalue, expected.report.eigenvalue);
  EXPECT_GT(greatest_distance(expected.positions, before.positions()), 0.1);
}

TEST_F(Spin_transform, writes_lambda_as_quaternions_of_any_library)
{
  expect_spins_as<Eigen::Quaterniond>();
  expect_spins_as<boost::math::quaternion<double>>();
  expect_spins_as<std::array<double, 4>>();
  expect_spins_as<CGP::Quaternion<float>>();
}

TEST_F(Spin_transform, takes_a_constant_rho)
{
  const boost::static_property_map<double, Surface::Face_index> constant(0.25);
  const CGP::Spin_report report = CGP::spin_transform(mesh, constant, unbounded());
  EXPECT_NEAR(report.eigenvalue, -0.25, 1e-9);
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), before.positions()), 1e-7);
}

TEST_F(Spin_transform, leaves_the_mesh_alone_where_the_points_go_elsewhere)
{
  auto output = mesh.add_property_map<Vertex, Surface::Point>("output").first;
  ASSERT_TRUE(CGP::spin_transform(mesh, rho, unbounded().output_vertex_point_map(output)));
  expect_untouched();
  const CGP::Graph_view<Surface> graph(mesh, params::vertex_point_map(output), "test");
  EXPECT_EQ(graph.view().positions(), expected.positions);
}

TEST_F(Spin_transform, reads_and_writes_the_points_of_the_map_given)
{
  auto points = mesh.add_property_map<Vertex, Surface::Point>("points").first;
  for (const Vertex v : vertices(mesh)) {
    const Eigen::Vector3d p = 2 * before.position(static_cast<int>(v));
    points[v] = {p.x(), p.y(), p.z()};
  }
  const auto half =
      boost::make_function_property_map<Vertex>([this](Vertex v) { return function(v) / 2; });
  ASSERT_TRUE(CGP::spin_transform(mesh, half, unbounded().vertex_point_map(points)));
  expect_untouched();
  const CGP::Graph_view<Surface> graph(mesh, params::vertex_point_map(points), "test");
  EXPECT_EQ(graph.view().positions(), 2 * expected.positions);
}

TEST_F(Spin_transform, passes_its_parameters_on)
{
  EXPECT_FALSE(CGP::spin_transform(mesh, rho, unbounded().number_of_iterations(1)));
  expect_untouched();
  const auto strong =
      boost::make_function_property_map<Vertex>([this](Vertex v) { return 6 * function(v); });
  CGP::Dirac_options dirac;
  dirac.max_substeps = 1;
  EXPECT_FALSE(CGP::spin_transform(mesh, strong, unbounded().dirac(dirac)));
  expect_untouched();
  Surface rough = mesh;
  const CGP::Spin_report report =
      CGP::spin_transform(rough, rho, unbounded().tolerance(1e-4).random_seed(3));
  EXPECT_TRUE(report);
  EXPECT_LT(report.iterations, expected.report.iterations);
  dirac = {};
  dirac.problem = CGP::Dirac_options::Eigenproblem::generalized;
  EXPECT_THROW((void)CGP::spin_transform(mesh, rho, unbounded().dirac(dirac)),
               CGP::Precondition_error);  // rho is not on faces
  expect_untouched();
  dirac = {};
  dirac.eigensolver = CGP::Inverse_power_eigensolver_traits();
  ASSERT_TRUE(CGP::spin_transform(mesh, rho, unbounded().dirac(dirac).tolerance(1e-7)));
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.positions), 1e-5);
}

TEST_F(Spin_transform, is_watched_and_stopped_by_a_visitor)
{
  Counter all(1000), few(2);
  Surface copy = mesh;
  EXPECT_TRUE(CGP::spin_transform(copy, rho, unbounded().visitor(std::ref(all))));
  EXPECT_EQ(all.count, expected.report.iterations);
  const Eigen::Quaterniond initial(1, 2, 3, 4);
  auto lambda = mesh.add_property_map<Vertex, Eigen::Quaterniond>("lambda", initial).first;
  const CGP::Spin_report report =
      CGP::spin_transform(mesh, rho, unbounded().visitor(std::ref(few)).vertex_spin_map(lambda));
  EXPECT_TRUE(report.cancelled);
  EXPECT_FALSE(report);
  EXPECT_EQ(few.count, 2);
  expect_untouched();
  for (const Vertex v : vertices(mesh)) EXPECT_EQ(lambda[v].coeffs(), initial.coeffs());
}

}  // namespace cgp_test::spin_transform_tests
