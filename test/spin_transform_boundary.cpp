// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/spin_transform.h
// Tests include/Conformal_geometry_processing/core/boundary_parameters.h
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <stdexcept>
#include <string>

#include "spin_transform_boundary_checks.h"

namespace cgp_test::spin_transform_boundary_tests {

namespace params = CGP::parameters;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;
using CGP::Boundary_direction;
using Boundary_fault = CGP::Spin_report::Boundary_fault;

template <class T>
auto constant(const T& value)
{
  return boost::static_property_map<T, Vertex>(value);
}

const Boundary_direction tangent{1, 0, 0}, binormal{0, 0, 1};

class Spin_transform_with_boundary : public testing::Test {
 protected:
  void expect_untouched(const Surface& surface) const
  {
    EXPECT_EQ(view_of(surface).positions(), before.positions());
  }

  /// Returns the message with which the transformation is rejected; checks that nothing is written
  template <class NamedParameters>
  std::string refusal(const NamedParameters& np)
  {
    std::string message;
    try {
      (void)CGP::spin_transform(mesh, constant(0.), np);
    } catch (const CGP::Precondition_error& error) {
      EXPECT_EQ(error.function(), "spin_transform");
      message = error.message();
    }
    expect_untouched(mesh);
    return message;
  }

  Surface mesh = to_cgal_mesh<Surface>(disk(6));
  const Mesh_view before = view_of(mesh);
};

TEST_F(Spin_transform_with_boundary, keeps_the_directions_that_are_only_named)
{
  const auto rho = constant(1.);
  const CGP::Spin_report report =
      CGP::spin_transform(mesh, rho, unbounded().boundary_direction(tangent));
  EXPECT_TRUE(report);
  const auto expected =
      CGP::Spin_transformation(before, {Boundary_condition::tangents()})
          .transform(Curvature_potential::on_vertices(Eigen::VectorXd::Ones(127)));
  EXPECT_EQ(view_of(mesh).positions(), expected.positions);
  EXPECT_EQ(report.direction_error.max, expected.report.direction_error.max);
}

TEST_F(Spin_transform_with_boundary, realises_a_constant_only_where_something_is_prescribed)
{
  Surface kept = mesh;
  const CGP::Spin_report binormals =
      CGP::spin_transform(kept, constant(.7), unbounded().boundary_direction(binormal));
  EXPECT_NEAR(binormals.eigenvalue, -.7, 1e-9);
  EXPECT_LT(greatest_distance(view_of(kept).positions(), before.positions()), 1e-6);
}

TEST_F(Spin_transform_with_boundary, takes_the_branch_and_the_kernel_that_it_is_told)
{
  const auto near_a_zero = constant(2.4);
  Surface other = mesh;
  const auto directions = unbounded().boundary_direction(binormal);
  CGP::Dirac_options dirac;
  dirac.branch = CGP::Dirac_options::Branch::smallest;
  const CGP::Spin_report smallest = CGP::spin_transform(mesh, near_a_zero, directions.dirac(dirac));
  EXPECT_NEAR(smallest.eigenvalue + 2.4, 2.4048, .05);
  const CGP::Spin_report nearest = CGP::spin_transform(other, near_a_zero, directions);
  EXPECT_NEAR(nearest.eigenvalue, -2.4, 1e-6);

  // Of a cylinder become planes and catenoids, in any proportion.
  Surface one = to_cgal_mesh<Surface>(cylinder(1, 2, 24, 8)), several = one;
  const auto tangents = unbounded().boundary_direction(tangent).exactness(std::nullopt);
  const CGP::Spin_report vector = CGP::spin_transform(one, constant(-.5), tangents);
  dirac = {};
  dirac.kernel_tolerance = .2;
  const CGP::Spin_report mixture =
      CGP::spin_transform(several, constant(-.5), tangents.dirac(dirac));
  EXPECT_GT(mixture.overlap, vector.overlap);
}

TEST_F(Spin_transform_with_boundary, reports_impossible_data_and_leaves_the_mesh)
{
  const CGP::Spin_report report = CGP::spin_transform(
      mesh, constant(0.), params::boundary_direction_map(constant(Kernel::Vector_3(1, 0, 0))));
  EXPECT_FALSE(report);
  EXPECT_TRUE(report.converged);
  EXPECT_EQ(report.boundary_fault, Boundary_fault::not_realizable);
  expect_untouched(mesh);
}

TEST_F(Spin_transform_with_boundary, refuses_what_does_not_fit_the_boundary)
{
  EXPECT_EQ(refusal(params::boundary_direction(Boundary_direction{0, 1, 0})),
            "only tangents, binormals and directions between them and the normal can be "
            "prescribed; that of the normal is not elliptic");
  EXPECT_EQ(refusal(params::boundary_direction_map(constant(Kernel::Vector_3(0, 0, 0)))),
            "36 directions zero or not finite, the first is vertex 91; finite vectors that are not "
            "zero are needed");
  const auto points = boost::make_function_property_map<Vertex>(
      [this](Vertex v) -> const Kernel::Point_3& { return mesh.point(v); });
  const auto inside =
      boost::make_function_property_map<Vertex>([](Vertex v) { return v < Vertex(91); });
  EXPECT_EQ(refusal(params::vertex_target_point_map(points).vertex_is_constrained_map(inside)),
            "36 boundary vertices not constrained, the first is vertex 91; the problem is well "
            "posed only if all of the boundary is");
  const auto twisted = boost::make_function_property_map<Vertex>([this](Vertex v) {
    const Kernel::Point_3 p = mesh.point(v);  // cos N + sin B
    return Kernel::Vector_3(p.y() * p.x(), p.y() * p.y(), p.x());
  });
  EXPECT_NE(refusal(params::vertex_target_point_map(points).vertex_normal_map(twisted))
                .find("twisted by a full turn"),
            std::string::npos);
}

TEST_F(Spin_transform_with_boundary, refuses_to_prescribe_the_boundary_of_a_closed_surface)
{
  Surface sphere = to_cgal_mesh<Surface>(icosahedron());
  try {
    (void)CGP::spin_transform(sphere, constant(0.), params::boundary_direction(tangent));
    FAIL() << "no exception";
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(error.message(), "the surface is closed; no boundary can be prescribed");
  }
}

TEST_F(Spin_transform_with_boundary, leaves_the_mesh_if_a_map_of_the_boundary_throws)
{
  const auto broken = boost::make_function_property_map<Vertex>([](Vertex v) -> Kernel::Vector_3 {
    if (v == Vertex(100)) throw std::runtime_error("direction");
    return {1, 0, 0};
  });
  EXPECT_THROW(
      (void)CGP::spin_transform(mesh, constant(0.), params::boundary_direction_map(broken)),
      std::runtime_error);
  expect_untouched(mesh);
}

}  // namespace cgp_test::spin_transform_boundary_tests
