// Tests mesh/Mesh_view.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/meshes.h"
#include "support/thin_faces.h"

#include <cmath>
#include <type_traits>
#include <utility>

namespace cgp_test::surface_ref_tests {

namespace CGP = Conformal_geometry_processing;
using CGP::Surface_ref;

Mesh_view stretched_sphere()
{
  return mapped(bumpy_sphere(2),
                [](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.x(), 5 * p.y(), p.z()); });
}

/// Every sheet is a triangle whose edges join its corners, and shares add up to 1.
template <class Surface>
void expect_model(const Surface& model)
{
  const Surface_ref surface = model;
  EXPECT_EQ(&surface.positions(), &model.positions());
  EXPECT_EQ(surface.size_of_vertices(), model.positions().cols());
  EXPECT_EQ(surface.size_of_edges(), static_cast<int>(model.ends().size()));
  EXPECT_EQ(boundary_loops(surface), boundary_loops(model));
  double share = 0;
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const CGP::Sheet sheet = surface.sheet(s);
    ASSERT_LT(sheet.face, surface.size_of_faces());
    for (int c = 0; c < 3; ++c) {
      const int i = sheet.corners[at((c + 1) % 3)], j = sheet.corners[at((c + 2) % 3)],
                k = sheet.edges[at(c)];
      if (k < 0)
        EXPECT_EQ(i, j);
      else
        EXPECT_EQ(surface.ends(k), (std::array<int, 2>{std::min(i, j), std::max(i, j)}));
    }
    share += sheet.share;
    const bool is_last =
        s + 1 == surface.size_of_sheets() || surface.sheet(s + 1).triangle != sheet.triangle;
    if (!is_last) continue;
    EXPECT_NEAR(share, 1, 1e-12);
    share = 0;
  }
}

TEST(Surface_ref, refers_to_meshes_and_their_triangulations)
{
  for (const Mesh_view& mesh : {stretched_sphere(), torus(2, 1, 12, 8), disk(4)}) {
    expect_model(mesh);
    expect_model(CGP::Delaunay_view(mesh));
    expect_model(CGP::Delaunay_view(spoilt(mesh)));
  }
}

TEST(Surface_ref, of_a_mesh_has_its_faces_for_sheets)
{
  const Mesh_view mesh = bumpy_sphere(1);
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const CGP::Sheet sheet = Surface_ref(mesh).sheet(f);
    EXPECT_EQ(sheet.corners, mesh.corners(f));
    EXPECT_EQ(sheet.share, 1);
    EXPECT_NEAR(sheet.area, mesh.double_area_vector(f).norm() / 2, 1e-16);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(sheet.edges[at(c)], mesh.edge(3 * f + c));
      EXPECT_EQ(Eigen::Vector3d(sheet.vectors.col(c)), mesh.vector(3 * f + c));
    }
  }
}

TEST(Surface_ref, is_of_surfaces_only_and_follows_their_positions)
{
  EXPECT_TRUE((std::is_convertible_v<const Mesh_view&, Surface_ref>));
  EXPECT_FALSE((std::is_convertible_v<const Points&, Surface_ref>));
  Mesh_view mesh = icosphere(1);
  const Surface_ref surface = mesh, copy = surface;
  mesh.set_positions(2 * mesh.positions());
  EXPECT_NEAR(copy.position(3).norm(), 2, 1e-15);
}

TEST(Boundary_vertices_of_a_surface_ref, are_those_of_the_loops)
{
  const Mesh_view mesh = annulus(.4, 1, 20, 4);
  const std::vector<char> is_boundary = CGP::boundary_vertices(mesh);
  EXPECT_EQ(std::count(is_boundary.begin(), is_boundary.end(), 1), 40);
  const std::vector<char> none = CGP::boundary_vertices(icosphere(1));
  EXPECT_EQ(std::count(none.begin(), none.end(), 0), 42);
}

TEST(Mean_edge_length, counts_inner_edges_once)
{
  EXPECT_DOUBLE_EQ(CGP::mean_edge_length(single_triangle()), (2 + 1 + std::sqrt(5)) / 3);
  EXPECT_DOUBLE_EQ(CGP::mean_edge_length(unit_square()), (4 + std::sqrt(2)) / 5);
}

TEST(Mean_edge_length, of_a_regular_solid_is_that_of_each_edge)
{
  const Mesh_view mesh = scaled(icosahedron(), 3);
  const double edge = (mesh.position(mesh.ends(0)[1]) - mesh.position(mesh.ends(0)[0])).norm();
  EXPECT_NEAR(CGP::mean_edge_length(mesh), edge, 1e-14);
}

}  // namespace cgp_test::surface_ref_tests
