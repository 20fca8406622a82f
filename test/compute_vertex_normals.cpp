// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/compute_vertex_normals.h
#include <Conformal_geometry_processing/compute_vertex_normals.h>
#include <Conformal_geometry_processing/core/Conformal_mesh_traits_Surface_mesh.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include "support/cgal_meshes.h"
#include "support/meshes.h"

namespace cgp_test::compute_vertex_normals_tests {

namespace CGP = Conformal_geometry_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Surface = CGAL::Surface_mesh<Point>;

TEST(Compute_vertex_normals, fills_the_map_of_the_mesh_traits)
{
  Surface mesh = to_cgal_mesh<Surface>(icosahedron());
  const CGP::Conformal_mesh_traits<Surface> traits(mesh);
  CGP::compute_vertex_normals(mesh, traits.vertex_normal_map());
  // a vertex of the icosahedron about the origin lies on its own normal
  for (auto v : vertices(mesh)) {
    const Vector radius = mesh.point(v) - CGAL::ORIGIN;
    const Vector n = get(traits.vertex_normal_map(), v);
    EXPECT_NEAR((n - radius / std::sqrt(radius.squared_length())).squared_length(), 0, 1e-28);
  }
}

TEST(Compute_vertex_normals, uses_the_points_that_are_passed)
{
  Surface mesh = to_cgal_mesh<Surface>(grid(2, 2));
  const auto turned = mesh.add_property_map<Surface::Vertex_index, Point>("v:turned").first;
  for (auto v : vertices(mesh)) {
    const Point p = mesh.point(v);
    put(turned, v, Point(p.z(), p.x(), p.y()));
  }
  const auto normals = CGP::Conformal_mesh_traits<Surface>(mesh).vertex_normal_map();
  CGP::compute_vertex_normals(mesh, normals, CGP::parameters::vertex_point_map(turned));
  for (auto v : vertices(mesh)) EXPECT_EQ(get(normals, v), Vector(1, 0, 0));
}

TEST(Compute_vertex_normals, leaves_the_map_alone_when_it_refuses_the_mesh)
{
  Surface mesh = to_cgal_mesh<Surface>(tetrahedron());
  std::vector<Surface::Vertex_index> square;
  for (double x : {0., 1., 2., 3.}) square.push_back(mesh.add_vertex(Point(x, x * x, 9)));
  mesh.add_face(square);
  const auto normals = CGP::Conformal_mesh_traits<Surface>(mesh).vertex_normal_map();
  EXPECT_THROW(CGP::compute_vertex_normals(mesh, normals), CGP::Precondition_error);
  for (auto v : vertices(mesh)) EXPECT_EQ(get(normals, v), Vector(0, 0, 0));
}

}  // namespace cgp_test::compute_vertex_normals_tests
