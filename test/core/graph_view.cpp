// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Graph_view.h
#include <Conformal_geometry_processing/core/Graph_view.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include "core/graph_view_checks.h"
#include "support/cgal_meshes.h"

namespace cgp_test::graph_view_tests {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

TEST(Graph_view, of_a_Surface_mesh_has_its_triangles)
{
  expect_view_of(icosphere(1), to_cgal_mesh<Surface>(icosphere(1)));
  expect_view_of(cylinder(1, 2, 5, 2), to_cgal_mesh<Surface>(cylinder(1, 2, 5, 2)));
}

TEST(Graph_view, keeps_the_order_of_vertices_and_faces)
{
  const Mesh_view torus = cgp_test::torus(2, 1, 5, 4);
  const auto graph = graph_view(to_cgal_mesh<Surface>(torus));
  EXPECT_EQ(graph.view().positions(), torus.positions());
  for (int f = 0; f < torus.size_of_faces(); ++f)
    EXPECT_NEAR((graph.view().double_area_vector(f) - torus.double_area_vector(f)).norm(), 0,
                1e-14);
}

TEST(Graph_view, numbers_only_the_live_elements_of_a_mesh_with_garbage)
{
  // vertices and faces of the first sphere are removed, and not collected
  Surface mesh = to_cgal_mesh<Surface>(disjoint_union(icosahedron(), icosphere(1), {5, 0, 0}));
  for (int f = 0; f < 20; ++f)
    CGAL::Euler::remove_face(halfedge(Surface::Face_index(unsigned(f)), mesh), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  const Mesh_view moved = mapped(icosphere(1), [](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p + Eigen::Vector3d(5, 0, 0));
  });
  expect_view_of(moved, mesh);
}

TEST(Graph_view, writes_positions_into_the_mesh)
{
  Surface mesh = to_cgal_mesh<Surface>(icosphere(1));
  expect_positions_are_written(mesh);
}

TEST(Graph_view, reads_the_point_map_that_is_passed_instead_of_the_mesh)
{
  Surface mesh = to_cgal_mesh<Surface>(tetrahedron());
  const auto points =
      mesh.add_property_map<Surface::Vertex_index, Point>("v:other", {1, 2, 3}).first;
  const auto graph = graph_view(mesh, CGP::parameters::vertex_point_map(points));
  EXPECT_EQ(graph.view().position(3), Eigen::Vector3d(1, 2, 3));
}

TEST(Graph_view, of_an_empty_mesh_is_empty)
{
  EXPECT_EQ(graph_view(Surface()).view().size_of_vertices(), 0);
}

TEST(Graph_view, refuses_a_quadrilateral_and_names_it)
{
  Surface mesh = to_cgal_mesh<Surface>(tetrahedron());
  std::vector<Surface::Vertex_index> v;
  for (int i = 0; i < 4; ++i) v.push_back(mesh.add_vertex(Point(i, i * i, 9)));
  mesh.add_face(v);
  EXPECT_EQ(refusal(mesh), "graph_view: face 4 is not a triangle; triangulate the mesh first");
}

}  // namespace cgp_test::graph_view_tests
