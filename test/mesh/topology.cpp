// Tests include/Conformal_geometry_processing/mesh/topology.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/topology.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace cgp_test::topology_tests {

namespace CGP = Conformal_geometry_processing;

void expect_topology(const Mesh_view& mesh, int components, int loops, int genus)
{
  const CGP::internal::Topology t = CGP::topology(mesh);
  EXPECT_EQ(t.vertices, mesh.size_of_vertices());
  EXPECT_EQ(t.edges, mesh.size_of_edges());
  EXPECT_EQ(t.faces, mesh.size_of_faces());
  EXPECT_EQ(t.components, components);
  EXPECT_EQ(t.boundary_loops, loops);
  EXPECT_EQ(t.genus, genus);
  EXPECT_EQ(t.euler_characteristic(), 2 * components - 2 * genus - loops);
  EXPECT_EQ(t.is_closed(), loops == 0);
  EXPECT_EQ(t.is_sphere(), components == 1 && loops == 0 && genus == 0);
  EXPECT_EQ(t.is_disk(), components == 1 && loops == 1 && genus == 0);
}

TEST(Topology, knows_spheres)
{
  expect_topology(tetrahedron(), 1, 0, 0);
  expect_topology(icosphere(2), 1, 0, 0);
  expect_topology(block(2, 3, 4), 1, 0, 0);
}

TEST(Topology, knows_disks)
{
  expect_topology(single_triangle(), 1, 1, 0);
  expect_topology(disk(5), 1, 1, 0);
  expect_topology(grid(3, 4), 1, 1, 0);
  expect_topology(without_face(tetrahedron(), 2), 1, 1, 0);
}

TEST(Topology, knows_annuli)
{
  expect_topology(annulus(1, 2, 8, 2), 1, 2, 0);
  expect_topology(cylinder(1, 2, 6, 3), 1, 2, 0);
}

TEST(Topology, counts_handles)
{
  expect_topology(torus(2, 1, 5, 4), 1, 0, 1);
  expect_topology(double_torus(), 1, 0, 2);
  expect_topology(without_face(double_torus(), 7), 1, 1, 2);
}

TEST(Topology, adds_up_the_components)
{
  const Mesh_view pair = disjoint_union(torus(2, 1, 4, 4), disk(2), {9, 0, 0});
  expect_topology(pair, 2, 1, 1);
  expect_topology(disjoint_union(pair, double_torus(), {0, 9, 0}), 3, 1, 3);
}

TEST(Topology, of_nothing_is_all_zeros)
{
  expect_topology(Mesh_view(), 0, 0, 0);
}

TEST(Connected_components, are_numbered_by_their_first_vertices)
{
  // Triangles (0, 3, 4) and (1, 2, 6), vertex 5 alone.
  const Mesh_view mesh(Points::Zero(3, 7), {{1, 2, 6}, {0, 3, 4}});
  EXPECT_EQ(CGP::connected_components(mesh), (std::vector<int>{0, 1, 1, 0, 0, 2, 1}));
}

TEST(Connected_components, are_found_whatever_the_numbering)
{
  const Mesh_view pair = disjoint_union(icosphere(1), torus(2, 1, 5, 4), {9, 0, 0});
  const std::vector<int> number = random_permutation(pair.size_of_vertices(), 3);
  const std::vector<int> component = CGP::connected_components(renumbered(pair, number));
  EXPECT_EQ(component.front(), 0);
  for (int v = 0; v < pair.size_of_vertices(); ++v)
    EXPECT_EQ(component[at(number[at(v)])] == component[at(number[0])], v < 42);
  EXPECT_EQ(*std::max_element(component.begin(), component.end()), 1);
}

}  // namespace cgp_test::topology_tests
