// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/core/Graph_view.h
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>

#include "core/graph_view_checks.h"
#include "support/cgal_meshes.h"

namespace cgp_test::graph_view_face_filtered_graph_tests {

using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

TEST(Graph_view_of_a_face_filtered_graph, has_the_selected_triangles_and_their_vertices_only)
{
  Surface whole = to_cgal_mesh<Surface>(disjoint_union(cube(), icosphere(1), {5, 0, 0}));
  std::vector<Surface::Face_index> selected;
  for (unsigned f = 0; f < 12; ++f) selected.emplace_back(f);
  const CGAL::Face_filtered_graph<Surface> part(whole, selected);
  expect_view_of(cube(), part);
}

}  // namespace cgp_test::graph_view_face_filtered_graph_tests
