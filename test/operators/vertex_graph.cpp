// Tests include/Conformal_geometry_processing/operators/vertex_graph.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::vertex_graph_tests {

namespace CGP = Conformal_geometry_processing;

TEST(Vertex_graph, of_two_triangles_has_columns_of_a_diagonal_and_the_larger_neighbours)
{
  const auto pattern = CGP::vertex_graph(unit_square());
  EXPECT_EQ(pattern->offsets, (std::vector<int>{0, 4, 6, 8, 9}));
  EXPECT_EQ(pattern->indices, (std::vector<int>{0, 1, 2, 3, 1, 2, 2, 3, 3}));
}

TEST(Vertex_graph, knows_the_position_of_every_edge_and_vertex)
{
  for (const Mesh_view& mesh : {icosphere(2), disk(4), double_torus(),
                                renumbered(icosphere(1), random_permutation(42, 7))}) {
    const auto pattern = CGP::vertex_graph(mesh);
    EXPECT_EQ(pattern->size(), mesh.size_of_vertices());
    EXPECT_EQ(pattern->size_of_entries(), mesh.size_of_vertices() + mesh.size_of_edges());
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_EQ(CGP::diagonal_position(*pattern, v), pattern->find(v, v));
    for (int k = 0; k < mesh.size_of_edges(); ++k) {
      const int low = mesh.ends(k)[0], high = mesh.ends(k)[1], place = k + low + 1;
      EXPECT_EQ(pattern->find(high, low), place);
      for (const int edge : {k, k - 1, k + 1, -1, pattern->size_of_entries()})  // others mislead
        EXPECT_EQ(CGP::internal::entry_position(*pattern, high, low, edge), place);
    }
  }
}

TEST(Vertex_graph, keeps_the_diagonal_of_a_vertex_without_faces)
{
  const Mesh_view mesh(Points::Zero(3, 4), {{0, 1, 3}});
  const auto pattern = CGP::vertex_graph(mesh);
  EXPECT_EQ(pattern->offsets, (std::vector<int>{0, 3, 5, 6, 7}));
  EXPECT_EQ(pattern->indices, (std::vector<int>{0, 1, 3, 1, 3, 2, 3}));
}

TEST(Vertex_graph, of_nothing_is_empty)
{
  EXPECT_EQ(CGP::vertex_graph(Mesh_view())->size(), 0);
}

}  // namespace cgp_test::vertex_graph_tests
