// Tests include/Conformal_geometry_processing/mesh/Mesh_view.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Quaternionic_linear_algebra/exceptions.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/meshes.h"

namespace cgp_test::mesh_view_tests {

namespace CGP = Conformal_geometry_processing;

std::vector<Mesh_view> sample_meshes()
{
  return {icosphere(1), torus(2, 1, 5, 4), disk(3), annulus(1, 2, 6, 2), tetrahedron()};
}

TEST(Mesh_view, numbers_the_edges_of_two_triangles_by_their_sorted_ends)
{
  const Mesh_view square = unit_square();
  ASSERT_EQ(square.size_of_vertices(), 4);
  ASSERT_EQ(square.size_of_faces(), 2);
  ASSERT_EQ(square.size_of_halfedges(), 6);
  ASSERT_EQ(square.size_of_edges(), 5);
  const std::array<int, 2> wanted[] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {2, 3}};
  for (int k = 0; k < 5; ++k) EXPECT_EQ(square.ends(k), wanted[k]);
}

TEST(Mesh_view, runs_halfedge_c_along_the_edge_opposite_corner_c)
{
  const Mesh_view mesh = single_triangle();
  EXPECT_EQ(mesh.from(0), 1);
  EXPECT_EQ(mesh.to(0), 2);
  EXPECT_EQ(mesh.from(1), 2);
  EXPECT_EQ(mesh.to(1), 0);
  EXPECT_EQ(mesh.from(2), 0);
  EXPECT_EQ(mesh.to(2), 1);
  EXPECT_EQ(mesh.vector(0), Eigen::Vector3d(-2, 1, 0));
  EXPECT_EQ(mesh.vector(1), Eigen::Vector3d(0, -1, 0));
  EXPECT_EQ(mesh.vector(2), Eigen::Vector3d(2, 0, 0));
}

TEST(Mesh_view, walks_around_a_face_from_end_to_end)
{
  for (const Mesh_view& mesh : sample_meshes())
    for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
      const int next = Mesh_view::next_in_face(h);
      EXPECT_EQ(mesh.to(h), mesh.from(next));
      EXPECT_EQ(Mesh_view::previous_in_face(next), h);
      EXPECT_EQ(Mesh_view::face(next), Mesh_view::face(h));
      EXPECT_EQ(Mesh_view::next_in_face(Mesh_view::next_in_face(next)), h);
    }
}

TEST(Mesh_view, pairs_each_interior_halfedge_with_the_opposite_one)
{
  for (const Mesh_view& mesh : sample_meshes())
    for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
      const int g = mesh.twin(h);
      if (g < 0) continue;
      EXPECT_EQ(mesh.twin(g), h);
      EXPECT_EQ(mesh.from(g), mesh.to(h));
      EXPECT_EQ(mesh.to(g), mesh.from(h));
      EXPECT_EQ(mesh.edge(g), mesh.edge(h));
      EXPECT_NE(Mesh_view::face(g), Mesh_view::face(h));
    }
}

TEST(Mesh_view, has_no_twins_at_the_boundary_alone)
{
  const Mesh_view mesh = disk(3);
  int count = 0;
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0) {
      ++count;
      EXPECT_NEAR(mesh.position(mesh.from(h)).norm(), 1, 1e-15);
      EXPECT_NEAR(mesh.position(mesh.to(h)).norm(), 1, 1e-15);
    }
  EXPECT_EQ(count, 18);
}

TEST(Mesh_view, lists_every_halfedge_under_its_edge_and_sorts_the_edges)
{
  for (const Mesh_view& mesh : sample_meshes()) {
    int listed = 0;
    for (int k = 0; k < mesh.size_of_edges(); ++k) {
      EXPECT_LT(mesh.ends(k)[0], mesh.ends(k)[1]);
      EXPECT_TRUE(k == 0 || mesh.ends(k - 1) < mesh.ends(k));
      for (const int* h = mesh.halfedges_begin(k); h != mesh.halfedges_end(k); ++h, ++listed) {
        EXPECT_EQ(mesh.edge(*h), k);
        EXPECT_EQ(std::min(mesh.from(*h), mesh.to(*h)), mesh.ends(k)[0]);
        EXPECT_EQ(std::max(mesh.from(*h), mesh.to(*h)), mesh.ends(k)[1]);
      }
    }
    EXPECT_EQ(listed, mesh.size_of_halfedges());
  }
}

TEST(Mesh_view, keeps_three_faces_on_one_edge_without_pairing_them)
{
  const Mesh_view book(Points::Random(3, 5), {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(book.ends(0), (std::array<int, 2>{0, 1}));
  EXPECT_EQ(book.halfedges_end(0) - book.halfedges_begin(0), 3);
  for (int h = 0; h < 9; ++h) EXPECT_EQ(book.twin(h), -1);
}

TEST(Mesh_view, points_the_area_vector_outward_with_twice_the_area)
{
  EXPECT_EQ(single_triangle().double_area_vector(0), Eigen::Vector3d(0, 0, 2));
  const Mesh_view solid = tetrahedron();
  for (int f = 0; f < 4; ++f) {
    Eigen::Vector3d outward = Eigen::Vector3d::Zero();
    for (int v : solid.corners(f)) outward += solid.position(v);
    const Eigen::Vector3d a = solid.double_area_vector(f);
    EXPECT_NEAR(a.norm(), 4 * std::sqrt(3.), 1e-14);  // 2 * sqrt(3) / 4 * 8
    EXPECT_NEAR(a.normalized().dot(outward.normalized()), 1, 1e-15);
  }
}

TEST(Mesh_view, takes_area_vectors_at_other_positions_too)
{
  const Mesh_view mesh = single_triangle();
  EXPECT_EQ(mesh.double_area_vector(0, 3 * mesh.positions()), Eigen::Vector3d(0, 0, 18));
  EXPECT_EQ(mesh.double_area_vector(0), Eigen::Vector3d(0, 0, 2));
}

TEST(Mesh_view, keeps_its_connectivity_when_positions_change)
{
  Mesh_view mesh = icosphere(1);
  const Mesh_view before = mesh;
  mesh.set_positions(2 * before.positions());
  EXPECT_EQ(mesh.positions(), 2 * before.positions());
  EXPECT_EQ(mesh.corners(), before.corners());
  for (int k = 0; k < mesh.size_of_edges(); ++k) EXPECT_EQ(mesh.ends(k), before.ends(k));
}

TEST(Mesh_view, can_be_empty)
{
  for (const Mesh_view& mesh : {Mesh_view(), Mesh_view(Points(3, 0), {})}) {
    EXPECT_EQ(mesh.size_of_vertices(), 0);
    EXPECT_EQ(mesh.size_of_edges(), 0);
    EXPECT_EQ(mesh.size_of_faces(), 0);
  }
}

std::string refusal_of(const Mesh_view::Corners& corners)
{
  try {
    Mesh_view(Points::Zero(3, 4), corners);
  } catch (const CGP::Precondition_error& error) {
    return error.message();
  }
  return "";
}

TEST(Mesh_view, refuses_corners_that_are_no_vertices)
{
  EXPECT_EQ(refusal_of({{0, 1, 2}, {0, 2, 4}}), "face 1 has the corner 4; vertices are 0 to 3");
  EXPECT_EQ(refusal_of({{-1, 1, 2}}), "face 0 has the corner -1; vertices are 0 to 3");
  EXPECT_NE(refusal_of({{0, (std::numeric_limits<int>::max)(), 2}}), "");
  EXPECT_EQ(refusal_of({{0, 1, 2}, {0, 2, 3}}), "");
  EXPECT_THROW(Mesh_view(Points(3, 0), {{0, 0, 0}}), CGP::Precondition_error);
}

TEST(Mesh_view, refuses_positions_that_are_not_one_per_vertex)
{
  Mesh_view mesh = icosphere(1);
  const Points before = mesh.positions();
  EXPECT_THROW(mesh.set_positions(before.leftCols(3)), CGP::Precondition_error);
  EXPECT_EQ(mesh.positions(), before);
}

}  // namespace cgp_test::mesh_view_tests
