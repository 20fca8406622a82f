// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "spin_transform_checks.h"
#include "support/bounded_meshes.h"

/// What spin_transform() does to a mesh of any type with boundary, measured against the class.
namespace cgp_test {

using CGP::Boundary_condition;

inline Mesh_view cap_to_transform()
{
  return cap_from_disk(jittered_disk(5, .3), 1);
}

/// where the points of the cap go, and its binormals, more or less
inline Eigen::Vector3d new_point(const Eigen::Vector3d& p)
{
  return {1.2 * p.x(), p.y() + .1 * p.x() * p.x(), .8 * p.z()};
}

inline Eigen::Vector3d new_direction(const Eigen::Vector3d& p)
{
  return {p.x(), p.y() + .2, -2 * p.z()};
}

/// Returns the columns of the boundary vertices
inline Points at_boundary(const Mesh_view& mesh, const Points& all)
{
  const std::vector<int> vertices = CGP::boundary_frames(mesh).vertices;
  Points p(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t k = 0; k < vertices.size(); ++k) p.col(int(k)) = all.col(vertices[k]);
  return p;
}

/// a map with a value made from three coordinates for each vertex
template <class Value, class Mesh>
auto map_of_columns(const Mesh& mesh, const Points& columns)
{
  auto map = get(CGAL::dynamic_vertex_property_t<Value>(), mesh);
  Eigen::Index v = 0;
  for (const auto vertex : vertices(mesh)) {
    const Eigen::Vector3d p = columns.col(v++);
    put(map, vertex, Value(p.x(), p.y(), p.z()));
  }
  return map;
}

/// Not on a copy, because the maps in `np` refer to vertices of this mesh; its points are restored
template <class Mesh, class NamedParameters>
void expect_transformation(Mesh& mesh, const NamedParameters& np,
                           const Boundary_condition& condition, double tolerance)
{
  const auto none = CGP::parameters::default_values();
  const CGP::Graph_view<Mesh> graph(mesh, none, "test");
  const Mesh_view before = graph.view();
  auto rho = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  const auto potential = Curvature_potential::on_vertices(rho_on_vertices(before).values / 4);
  fill(vertices(mesh), rho, potential.values);
  const CGP::Spin_report report = CGP::spin_transform(mesh, rho, np);
  EXPECT_TRUE(report);
  const CGP::Spin_result expected =
      CGP::Spin_transformation(before, {condition}).transform(potential);
  EXPECT_LT(greatest_distance(view_of(mesh).positions(), expected.positions), tolerance);
  EXPECT_GT(greatest_distance(before.positions(), expected.positions), .01);
  EXPECT_EQ(report.eigenvalue, expected.report.eigenvalue);
  CGP::internal::write_points(mesh, graph, before.positions(), none);
}

/// with the boundary free, with its binormals prescribed, and with its positions
template <class Mesh>
void expect_transformation_with_boundary(Mesh mesh, double tolerance)
{
  namespace params = CGP::parameters;
  using Point_map = typename boost::property_map<Mesh, CGAL::vertex_point_t>::const_type;
  using Point = typename boost::property_traits<Point_map>::value_type;
  const Mesh_view before = view_of(mesh);
  expect_transformation(mesh, unbounded(), {}, tolerance);

  const Points turned = mapped(before, new_direction).positions();
  const auto directions = map_of_columns<Eigen::Vector3d>(mesh, turned);
  expect_transformation(mesh,
                        params::boundary_direction(CGP::Boundary_direction{0, 0, 1})
                            .boundary_direction_map(directions),
                        Boundary_condition::binormals(at_boundary(before, turned)), tolerance);

  const Mesh_view moved = mapped(before, new_point);
  const Points normals = CGP::vertex_normals(moved, CGP::internal::Normal_weight::angle);
  expect_transformation(
      mesh, params::vertex_target_point_map(map_of_columns<Point>(mesh, moved.positions())),
      Boundary_condition::positions(at_boundary(before, moved.positions()),
                                    at_boundary(before, normals)),
      tolerance);
}

}  // namespace cgp_test
