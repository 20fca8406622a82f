// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Graph_view.h
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/graph_traits_Polyhedron_3.h>

#include "core/graph_view_checks.h"
#include "support/cgal_meshes.h"

namespace cgp_test::graph_view_polyhedron_3_tests {

using Kernel = CGAL::Simple_cartesian<double>;

template <class Polyhedron>
class Graph_view_of_a_polyhedron : public testing::Test {};

using Polyhedra = testing::Types<CGAL::Polyhedron_3<Kernel>,
                                 CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>;
TYPED_TEST_SUITE(Graph_view_of_a_polyhedron, Polyhedra, );

TYPED_TEST(Graph_view_of_a_polyhedron, has_its_triangles)
{
  expect_view_of(icosphere(1), to_cgal_mesh<TypeParam>(icosphere(1)));
  expect_view_of(grid(2, 3), to_cgal_mesh<TypeParam>(grid(2, 3)));
}

TYPED_TEST(Graph_view_of_a_polyhedron, writes_positions_into_the_mesh)
{
  auto mesh = to_cgal_mesh<TypeParam>(icosphere(1));
  expect_positions_are_written(mesh);
}

TYPED_TEST(Graph_view_of_a_polyhedron, refuses_a_pentagon)
{
  auto mesh = to_cgal_mesh<TypeParam>(icosahedron());
  mesh.erase_center_vertex((*vertices(mesh).begin())->halfedge());
  EXPECT_NE(refusal(mesh).find("is not a triangle"), std::string::npos);
}

}  // namespace cgp_test::graph_view_polyhedron_3_tests
