// Tests include/Conformal_geometry_processing/mesh/topology.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/topology.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::boundary_loops_tests {

namespace CGP = Conformal_geometry_processing;
using Loops = std::vector<std::vector<int>>;

/// the area enclosed by a loop in the plane, positive if it runs counter-clockwise
double enclosed_area(const Mesh_view& mesh, const std::vector<int>& loop)
{
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += mesh.position(loop[i]).cross(mesh.position(loop[(i + 1) % loop.size()])).z() / 2;
  return sum;
}

TEST(Boundary_loops, of_a_triangle_are_its_corners_in_order)
{
  EXPECT_EQ(CGP::boundary_loops(single_triangle()), (Loops{{0, 1, 2}}));
  EXPECT_EQ(CGP::boundary_loops(with_reversed_faces(single_triangle())), (Loops{{0, 2, 1}}));
}

TEST(Boundary_loops, of_a_square_go_around_it_and_not_along_the_diagonal)
{
  EXPECT_EQ(CGP::boundary_loops(unit_square()), (Loops{{0, 1, 2, 3}}));
}

TEST(Boundary_loops, of_closed_surfaces_are_none)
{
  EXPECT_TRUE(CGP::boundary_loops(icosphere(1)).empty());
  EXPECT_TRUE(CGP::boundary_loops(torus(2, 1, 4, 5)).empty());
}

TEST(Boundary_loops, have_the_surface_on_the_left)
{
  const Loops loops = CGP::boundary_loops(annulus(1, 2, 60, 3));
  ASSERT_EQ(loops.size(), 2u);  // the outer circle has the smaller numbers
  EXPECT_NEAR(enclosed_area(annulus(1, 2, 60, 3), loops[0]), 4 * pi, .1);
  EXPECT_NEAR(enclosed_area(annulus(1, 2, 60, 3), loops[1]), -pi, .1);
}

TEST(Boundary_loops, follow_edges_that_have_one_face)
{
  const Mesh_view mesh = without_face(without_face(icosphere(1), 70), 3);
  const Loops loops = CGP::boundary_loops(mesh);
  ASSERT_EQ(loops.size(), 2u);
  for (const auto& loop : loops) {
    EXPECT_EQ(loop.size(), 3u);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      int found = 0;
      for (int h = 0; h < mesh.size_of_halfedges(); ++h)
        found += mesh.from(h) == loop[i] && mesh.to(h) == loop[(i + 1) % loop.size()] &&
                 mesh.twin(h) < 0;
      EXPECT_EQ(found, 1);
    }
  }
}

TEST(Boundary_loops, start_at_their_smallest_vertex_and_are_sorted_by_it)
{
  const Mesh_view ring = annulus(1, 2, 8, 2);
  const Loops loops = CGP::boundary_loops(renumbered(ring, random_permutation(24, 5)));
  ASSERT_EQ(loops.size(), 2u);
  for (const auto& loop : loops) {
    EXPECT_EQ(loop.size(), 8u);
    EXPECT_EQ(loop.front(), *std::min_element(loop.begin(), loop.end()));
  }
  EXPECT_LT(loops[0].front(), loops[1].front());
}

TEST(Boundary_vertices, of_a_disk_are_those_of_its_outer_ring)
{
  const std::vector<char> is_boundary = CGP::boundary_vertices(disk(4));
  ASSERT_EQ(is_boundary.size(), 61u);
  for (int v = 0; v < 61; ++v) EXPECT_EQ(is_boundary[at(v)] != 0, v >= 37) << v;
}

TEST(Boundary_vertices, of_a_closed_surface_are_none)
{
  for (char is_boundary : CGP::boundary_vertices(tetrahedron())) EXPECT_FALSE(is_boundary);
}

}  // namespace cgp_test::boundary_loops_tests
