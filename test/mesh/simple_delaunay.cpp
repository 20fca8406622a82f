// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests mesh/Intrinsic_triangulation.h
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/random.h"
#include "support/thin_faces.h"
#include "support/tori.h"

#include <array>
#include <set>
#include <vector>

namespace cgp_test::simple_delaunay_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::internal::simple_delaunay;
using CGP::internal::with_opened_faces;

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

// Chords that stand for edges along the surface are shorter: what is Delaunay by the ones need not
// be by the others.
TEST(Delaunay_by_chords, is_delaunay_by_its_own_edges)
{
  for (const Mesh_view& mesh :
       {stretched(perturbed(icosphere(3), .04), 6), stretched(irregular_torus(2, 1, 24, 12), 5),
        stretched(disk(6), 5)}) {
    std::vector<std::array<int, 2>> flips, more;
    const Mesh_view delaunay = CGP::internal::delaunay_by_chords(mesh, 0, flips);
    EXPECT_GT(flips.size(), 50U);
    EXPECT_EQ(edges_that_are_not_delaunay(delaunay), 0);
    EXPECT_EQ(CGP::internal::delaunay_by_chords(delaunay, 0, more).corners(), delaunay.corners());
    EXPECT_TRUE(more.empty());
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

const double share = 1e-6;

/// the vertices of faces whose edges, more or less, form no triangle
std::set<int> vertices_of_thin_faces(const Mesh_view& mesh)
{
  std::set<int> vertices;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Eigen::Vector3d l;
    for (int c = 0; c < 3; ++c) l[c] = mesh.vector(3 * f + c).norm();
    if (l.sum() - 2 * l.maxCoeff() > 2 * share * l.maxCoeff()) continue;
    vertices.insert(mesh.corners(f).begin(), mesh.corners(f).end());
  }
  return vertices;
}

/// faces without area: caps, needles whose ends coincide, and both on a surface with handles
std::vector<Mesh_view> flat_meshes()
{
  return {with_thin_faces(icosphere(2), 0),
          with_thin_faces(icosphere(2), 0, 0),
          with_thin_faces(perturbed(icosphere(1), .2), 0, 0),
          spoilt(icosphere(2)),
          with_thin_faces(torus(2, 1, 24, 12), 0, 0),
          with_thin_faces(disk(5), 0, 0)};
}

TEST(With_opened_faces, have_an_area)
{
  for (const Mesh_view& mesh : flat_meshes()) {
    EXPECT_THROW(CGP::require_surface(mesh, "test"), CGP::Precondition_error);
    for (const Mesh_view& flat : {mesh, simple_delaunay(mesh, share)}) {
      const Mesh_view opened = with_opened_faces(flat, share);
      EXPECT_EQ(opened.corners(), flat.corners());
      EXPECT_NO_THROW(CGP::require_surface(opened, "test"));
    }
  }
}

// Twenty times by the root of the share of an edge, at most.
TEST(With_opened_faces, move_their_vertices_by_a_small_part_of_the_edges_and_no_others)
{
  for (const Mesh_view& mesh : flat_meshes()) {
    const Mesh_view opened = with_opened_faces(mesh, share);
    const Eigen::VectorXd moved = (opened.positions() - mesh.positions()).colwise().norm();
    double longest = 0;
    for (int h = 0; h < mesh.size_of_halfedges(); ++h)
      longest = std::max(longest, mesh.vector(h).norm());
    EXPECT_LT(moved.maxCoeff(), 20 * std::sqrt(share) * longest);
    EXPECT_GT(moved.maxCoeff(), 0);
    const std::set<int> thin = vertices_of_thin_faces(mesh);
    for (int v = 0; v < mesh.size_of_vertices(); ++v)
      EXPECT_TRUE(thin.count(v) > 0 || moved[v] == 0) << v;
  }
}

TEST(With_opened_faces, of_a_mesh_without_thin_faces_is_the_mesh)
{
  for (const Mesh_view& mesh : {icosphere(2), perturbed(irregular_torus(2, 1, 24, 12), .02)})
    EXPECT_EQ(with_opened_faces(mesh, share).positions(), mesh.positions());
}

TEST(With_opened_faces, do_not_depend_on_scale)
{
  const Mesh_view mesh = spoilt(icosphere(1)), wanted = with_opened_faces(mesh, share);
  for (const double size : {0x1p-330, 0x1p300}) {
    const CGP::Points found = with_opened_faces(scaled(mesh, size), share).positions() / size;
    EXPECT_LT((found - wanted.positions()).norm(), 1e-14);
  }
}

}  // namespace cgp_test::simple_delaunay_tests
