// Tests include/Conformal_geometry_processing/mesh/simple_delaunay.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/intrinsic_delaunay.h>
#include <Conformal_geometry_processing/mesh/mollified_lengths.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/simple_delaunay.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/random.h"
#include "support/tori.h"

namespace cgp_test::simple_delaunay_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::simple_delaunay;

int edges_that_are_not_delaunay(const Mesh_view& mesh)
{
  const CGP::internal::Intrinsic_triangulation triangles(mesh, CGP::edge_lengths(mesh));
  int count = 0;
  for (int h = 0; h < triangles.size_of_halfedges(); ++h)
    count += h < triangles.twin(h) && !CGP::is_delaunay(triangles, h);
  return count;
}

Mesh_view stretched(const Mesh_view& mesh, double factor)
{
  return mapped(mesh, [&](const Eigen::Vector3d& p) {
    return Eigen::Vector3d(factor * p.x(), p.y(), p.z());
  });
}

TEST(Simple_delaunay, of_a_mesh_that_is_delaunay_is_the_mesh)
{
  for (const Mesh_view& mesh : {icosphere(2), torus(2, 1, 24, 12)}) {
    ASSERT_EQ(edges_that_are_not_delaunay(mesh), 0);
    EXPECT_EQ(simple_delaunay(mesh).corners(), mesh.corners());
  }
}

TEST(Simple_delaunay, is_a_manifold_of_the_same_vertices_topology_and_boundary)
{
  for (const Mesh_view& mesh :
       {stretched(icosphere(3), 6), stretched(irregular_torus(2, 1, 24, 12), 5),
        stretched(disk(6), 5), perturbed(icosphere(1), .6), perturbed(icosphere(0), .5)}) {
    const Mesh_view delaunay = simple_delaunay(mesh);
    EXPECT_EQ(delaunay.positions(), mesh.positions());
    EXPECT_NO_THROW(CGP::require_surface(delaunay, "test"));
    const auto was = CGP::topology(mesh), is = CGP::topology(delaunay);
    EXPECT_EQ(is.edges, was.edges);
    EXPECT_EQ(is.genus, was.genus);
    EXPECT_EQ(is.boundary_loops, was.boundary_loops);
    EXPECT_GT(edges_that_are_not_delaunay(mesh), 0);
    EXPECT_LT(edges_that_are_not_delaunay(delaunay), edges_that_are_not_delaunay(mesh));
  }
}

TEST(Simple_delaunay, of_a_planar_mesh_has_no_other_edges)
{
  const Mesh_view mesh = stretched(disk(6), 4);
  EXPECT_GT(edges_that_are_not_delaunay(mesh), 0);
  EXPECT_EQ(edges_that_are_not_delaunay(simple_delaunay(mesh)), 0);
}

TEST(Simple_delaunay, leaves_out_flips_that_would_join_two_vertices_twice)
{
  // A flat tetrahedron: the long edge has large opposite angles, its ends' other joint is an edge.
  const Mesh_view mesh(points({{0, 0, 0}, {4, 0, 0}, {2, .5, .1}, {2, -.5, .1}}),
                       {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  EXPECT_GT(edges_that_are_not_delaunay(mesh), 0);
  EXPECT_EQ(simple_delaunay(mesh).corners(), mesh.corners());
}

TEST(Simple_delaunay, does_not_depend_on_the_size)
{
  const Mesh_view mesh = stretched(irregular_torus(2, 1, 24, 12), 5);
  const Mesh_view::Corners wanted = simple_delaunay(mesh).corners();
  ASSERT_NE(wanted, mesh.corners());
  for (const double size : {1e-150, 1e-80, 3., 1e80, 1e150})
    EXPECT_EQ(simple_delaunay(scaled(mesh, size)).corners(), wanted) << size;
}

}  // namespace cgp_test::simple_delaunay_tests
