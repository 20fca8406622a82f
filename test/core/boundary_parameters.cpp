// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/boundary_parameters.h
#include <Conformal_geometry_processing/core/Graph_view.h>
#include <Conformal_geometry_processing/core/boundary_parameters.h>
#include <Conformal_geometry_processing/core/named_parameters.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <boost/property_map/function_property_map.hpp>

#include <string>

#include "support/bounded_meshes.h"
#include "support/cgal_meshes.h"

namespace cgp_test::boundary_parameters_tests {

namespace CGP = Conformal_geometry_processing;
namespace params = CGP::parameters;
using Kind = CGP::Boundary_condition::Kind;
using Kernel = CGAL::Simple_cartesian<double>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Surface::Vertex_index;

class Boundary_parameters : public testing::Test {
 protected:
  template <class NamedParameters>
  CGP::Boundary_condition condition(const NamedParameters& np) const
  {
    return CGP::internal::boundary_condition(graph, np, "f");
  }

  /// the points p of the mesh with (2 x, y, 3 + x^2), as T
  template <class T>
  auto image() const
  {
    return boost::make_function_property_map<Vertex>([this](Vertex v) {
      const Kernel::Point_3 p = mesh.point(v);
      return T(2 * p.x(), p.y(), 3 + p.x() * p.x());
    });
  }

  Points expected_image() const
  {
    return at_boundary([](const Eigen::Vector3d& p) -> Eigen::Vector3d {
      return {2 * p.x(), p.y(), 3 + p.x() * p.x()};
    });
  }

  template <class Function>
  Points at_boundary(Function f) const
  {
    const std::vector<int> vertices = CGP::boundary_frames(view).vertices;
    Points p(3, int(vertices.size()));
    for (std::size_t k = 0; k < vertices.size(); ++k) p.col(int(k)) = f(view.position(vertices[k]));
    return p;
  }

  const Mesh_view view = disk(3);
  const Surface mesh = to_cgal_mesh<Surface>(view);
  const CGP::Graph_view<Surface> graph{mesh, params::default_values(), "f"};
};

TEST_F(Boundary_parameters, that_are_not_there_leave_the_boundary_free)
{
  EXPECT_EQ(condition(params::tolerance(.1)).kind, Kind::free);
}

TEST_F(Boundary_parameters, with_a_direction_map_prescribe_tangents)
{
  const auto c = condition(params::boundary_direction_map(image<Kernel::Vector_3>()));
  EXPECT_EQ(c.kind, Kind::directions);
  EXPECT_EQ(c.direction, Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(c.targets, expected_image());
}

TEST_F(Boundary_parameters, with_a_direction_prescribe_that_one)
{
  const CGP::Boundary_direction d{1, 2, 3};
  const auto kept = condition(params::boundary_direction(d));
  EXPECT_EQ(kept.kind, Kind::directions);
  EXPECT_EQ(kept.direction, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(kept.targets.cols(), 0);
  const auto turned =
      condition(params::boundary_direction(d).boundary_direction_map(image<Kernel::Vector_3>()));
  EXPECT_EQ(turned.direction, Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(turned.targets, expected_image());
}

TEST_F(Boundary_parameters, with_target_points_prescribe_positions)
{
  const boost::static_property_map<Kernel::Vector_3, Vertex> up(Kernel::Vector_3(0, 0, 1));
  const auto c =
      condition(params::vertex_target_point_map(image<Kernel::Point_3>()).vertex_normal_map(up));
  EXPECT_EQ(c.kind, Kind::positions);
  EXPECT_EQ(c.targets, expected_image());
  EXPECT_EQ(c.normals, at_boundary([](const auto&) { return Eigen::Vector3d(0, 0, 1); }));
  EXPECT_TRUE(std::isinf(c.weight));
  const auto points = params::vertex_target_point_map(image<Kernel::Point_3>());
  EXPECT_EQ(condition(points.vertex_normal_map(up).position_weight(20)).weight, 20);
}

TEST_F(Boundary_parameters, without_normals_take_those_of_the_target_points)
{
  const auto c = condition(params::vertex_target_point_map(image<Kernel::Point_3>()));
  for (Eigen::Index k = 0; k < c.targets.cols(); ++k) {
    const double slope = c.targets(0, k) / 2;  // dz/dx of the parabola z = 3 + (x/2)^2 over x
    const Eigen::Vector3d exact = Eigen::Vector3d(-slope, 0, 1).normalized();
    EXPECT_LT((c.normals.col(k) - exact).norm(), .2);
  }
}

TEST_F(Boundary_parameters, want_all_of_the_boundary_constrained)
{
  const auto points = params::vertex_target_point_map(image<Kernel::Point_3>());
  const auto all = boost::make_function_property_map<Vertex>([](Vertex v) { return int(v) >= 19; });
  EXPECT_EQ(condition(points.vertex_is_constrained_map(all)).targets, expected_image());
  const auto some =
      boost::make_function_property_map<Vertex>([](Vertex v) { return int(v) >= 22; });
  try {
    (void)condition(points.vertex_is_constrained_map(some));
    FAIL() << "no exception";
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(std::string(error.what()),
              "f: 3 boundary vertices not constrained, the first is vertex 19; the problem is well "
              "posed only if all of the boundary is");
  }
}

TEST_F(Boundary_parameters, prescribe_positions_of_closed_curves_inside_too)
{
  const boost::static_property_map<Kernel::Vector_3, Vertex> up(Kernel::Vector_3(0, 0, 1));
  const auto inner = boost::make_function_property_map<Vertex>(
      [](Vertex v) { return int(v) >= 19 || (int(v) > 0 && int(v) < 7); });
  const auto c = condition(params::vertex_target_point_map(image<Kernel::Point_3>())
                               .vertex_normal_map(up)
                               .vertex_is_constrained_map(inner));
  EXPECT_EQ(c.curves, (std::vector<std::vector<int>>{{1, 2, 3, 4, 5, 6}}));
  ASSERT_EQ(c.targets.cols(), 24);
  EXPECT_EQ(c.normals.cols(), 24);
  EXPECT_EQ(c.targets.leftCols(18), expected_image());
  const Kernel::Point_3 p = get(image<Kernel::Point_3>(), Vertex(3));
  EXPECT_EQ(c.targets.col(20), Eigen::Vector3d(p.x(), p.y(), p.z()));
  const auto open = boost::make_function_property_map<Vertex>(
      [](Vertex v) { return int(v) >= 19 || int(v) == 3; });
  EXPECT_THROW((void)condition(params::vertex_target_point_map(image<Kernel::Point_3>())
                                   .vertex_is_constrained_map(open)),
               CGP::Precondition_error);
}

}  // namespace cgp_test::boundary_parameters_tests
