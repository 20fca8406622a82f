// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

#include <algorithm>
#include <limits>

namespace cgp_test::requirements_tests {

namespace CGP = Conformal_geometry_processing;
using Requirement = void (*)(const Mesh_view&, const std::string&);

/// Returns the message of the requirement, empty if it holds
std::string complaint(Requirement require, const Mesh_view& mesh)
{
  try {
    require(mesh, "some_function");
  } catch (const CGP::Precondition_error& error) {
    EXPECT_EQ(error.function(), "some_function");
    return error.message();
  }
  return "";
}

/// refused for this reason, also as part of all requirements of a surface
void expect_refused(Requirement require, const Mesh_view& mesh, const std::string& message)
{
  EXPECT_EQ(complaint(require, mesh), message);
  EXPECT_EQ(complaint(CGP::require_surface, mesh), message);
}

Mesh_view with_coordinate(Mesh_view mesh, int v, int axis, double value)
{
  Points p = mesh.positions();
  p(axis, v) = value;
  mesh.set_positions(p);
  return mesh;
}

Mesh_view with_faces(const Mesh_view& mesh, const Corners& more)
{
  Corners corners = mesh.corners();
  corners.insert(corners.end(), more.begin(), more.end());
  return {mesh.positions(), std::move(corners)};
}

/// an isosceles triangle with base 1 and the given height
Mesh_view flat_triangle(double height)
{
  return {points({{0, 0, 0}, {1, 0, 0}, {.5, height, 0}}), {{0, 1, 2}}};
}

TEST(Require_surface, accepts_every_oriented_manifold)
{
  for (const Mesh_view& mesh :
       {tetrahedron(), icosphere(2), torus(2, 1, 5, 4), double_torus(), single_triangle(),
        unit_square(), disk(3), annulus(1, 2, 6, 1), cylinder(1, 1, 4, 1)})
    EXPECT_EQ(complaint(CGP::require_surface, mesh), "");
}

TEST(Require_surface, names_the_function_that_asks)
{
  try {
    CGP::require_surface(Mesh_view(), "spin_transform");
    FAIL();
  } catch (const CGP::Precondition_error& error) {
    EXPECT_STREQ(error.what(), "spin_transform: the mesh has no faces");
  }
}

TEST(Require_not_empty, refuses_meshes_without_faces)
{
  expect_refused(CGP::require_not_empty, Mesh_view(), "the mesh has no faces");
  expect_refused(CGP::require_not_empty, Mesh_view(Points::Zero(3, 5), {}),
                 "the mesh has no faces");
}

TEST(Require_finite_positions, refuses_what_is_not_a_number)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_refused(CGP::require_finite_positions, with_coordinate(icosphere(1), 17, 2, nan),
                 "1 vertex with a coordinate that is not finite, the first is vertex 17; "
                 "finite coordinates are needed");
}

TEST(Require_finite_positions, refuses_infinity_of_either_sign)
{
  const double infinity = std::numeric_limits<double>::infinity();
  const Mesh_view mesh = with_coordinate(icosphere(1), 8, 0, -infinity);
  expect_refused(CGP::require_finite_positions, with_coordinate(mesh, 5, 1, infinity),
                 "2 vertices with a coordinate that is not finite, the first is vertex 5; "
                 "finite coordinates are needed");
}

TEST(Require_no_isolated_vertices, names_the_first)
{
  Points p(3, 7);
  p << tetrahedron().positions(), Points::Random(3, 3);
  expect_refused(CGP::require_no_isolated_vertices, {p, tetrahedron().corners()},
                 "3 vertices without a face, the first is vertex 4; remove them first");
}

TEST(Require_distinct_corners, refuses_a_repeated_vertex_in_any_two_places)
{
  for (const std::array<int, 3>& corners : Corners{{1, 1, 2}, {1, 2, 2}, {1, 2, 1}}) {
    const std::string name = "(vertices " + std::to_string(corners[0]) + ", " +
                             std::to_string(corners[1]) + ", " + std::to_string(corners[2]) + ")";
    expect_refused(
        CGP::require_distinct_corners, with_faces(tetrahedron(), {corners}),
        "1 face with a repeated vertex, the first is face 4 " + name + "; remove them first");
  }
}

TEST(Require_manifold_edges, refuses_three_faces_on_one_edge)
{
  const Mesh_view book(points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}),
                       {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  expect_refused(CGP::require_manifold_edges, book,
                 "1 non-manifold edge (more than two faces), the first is edge 0-1; "
                 "a manifold is needed");
}

TEST(Require_manifold_edges, refuses_a_face_that_is_turned_around)
{
  Corners corners = icosphere(1).corners();
  std::swap(corners[9][0], corners[9][1]);
  std::array<int, 3> v = corners[9];
  std::sort(v.begin(), v.end());
  expect_refused(CGP::require_manifold_edges, {icosphere(1).positions(), corners},
                 "3 edges whose two faces are oriented against each other, the first is edge " +
                     std::to_string(v[0]) + "-" + std::to_string(v[1]) +
                     "; a consistent orientation is needed");
}

TEST(Require_manifold_edges, refuses_a_moebius_strip)
{
  Points p(3, 5);
  for (int i = 0; i < 5; ++i) p.col(i) << i * i, i, i * i * i;
  const Mesh_view strip(p, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}, {4, 0, 1}});
  expect_refused(CGP::require_manifold_edges, strip,
                 "1 edge whose two faces are oriented against each other, the first is edge 0-1; "
                 "a consistent orientation is needed");
}

TEST(Require_manifold_vertices, refuses_two_disks_that_touch_in_a_vertex)
{
  const Mesh_view bow_tie(points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}),
                          {{0, 1, 2}, {0, 3, 4}});
  expect_refused(CGP::require_manifold_vertices, bow_tie,
                 "1 non-manifold vertex (several fans of faces), the first is vertex 0; "
                 "a manifold is needed");
}

TEST(Require_manifold_vertices, refuses_an_hourglass_of_closed_surfaces)
{
  const Mesh_view pair = disjoint_union(tetrahedron(), tetrahedron(), {9, 0, 0});
  Corners corners = pair.corners();
  for (auto& face : corners)
    for (int& v : face) v = v == 7 ? 3 : v;
  const Mesh_view hourglass(pair.positions().leftCols(7), corners);
  expect_refused(CGP::require_manifold_vertices, hourglass,
                 "1 non-manifold vertex (several fans of faces), the first is vertex 3; "
                 "a manifold is needed");
}

TEST(Require_manifold_vertices, refuses_an_open_fan_that_touches_a_closed_one)
{
  // A tetrahedron with one more triangle at its vertex 2.
  Points p(3, 6);
  p << tetrahedron().positions(), Points::Random(3, 2);
  expect_refused(CGP::require_manifold_vertices,
                 with_faces({p, tetrahedron().corners()}, {{2, 4, 5}}),
                 "1 non-manifold vertex (several fans of faces), the first is vertex 2; "
                 "a manifold is needed");
}

TEST(Require_manifold_vertices, ends_also_where_faces_are_turned_around)
{
  Corners corners = icosphere(1).corners();
  for (std::size_t f = 0; f < corners.size(); f += 3) std::swap(corners[f][0], corners[f][1]);
  EXPECT_NO_THROW(complaint(CGP::require_manifold_vertices, {icosphere(1).positions(), corners}));
}

TEST(Require_connected, refuses_two_components)
{
  expect_refused(CGP::require_connected, disjoint_union(icosphere(1), disk(2), {9, 0, 0}),
                 "the mesh has 2 components, the second begins at vertex 42; "
                 "one component is needed, transform each alone");
}

TEST(Require_positive_areas, refuses_faces_whose_corners_coincide_or_are_in_line)
{
  const Mesh_view mesh = icosphere(1);
  Points p = mesh.positions();
  const auto& corners = mesh.corners(30);
  p.col(corners[0]) = (p.col(corners[1]) + p.col(corners[2])) / 2;
  const std::string message = complaint(CGP::require_surface, {p, mesh.corners()});
  EXPECT_EQ(message.substr(0, 42), "1 face of area zero, the first is face 30 ") << message;
  expect_refused(CGP::require_positive_areas, Mesh_view(Points::Ones(3, 3), {{0, 1, 2}}),
                 "1 face of area zero, the first is face 0 (vertices 0, 1, 2); "
                 "remove or repair them first");
}

TEST(Require_positive_areas, refuses_slivers_that_are_rounding_errors)
{
  expect_refused(CGP::require_positive_areas, flat_triangle(1e-14),
                 "1 face of area zero, the first is face 0 (vertices 0, 1, 2); "
                 "remove or repair them first");
}

TEST(Require_positive_areas, accepts_slivers_of_a_millionth_of_a_degree)
{
  const double radians = 1e-6 * pi / 180;
  EXPECT_EQ(complaint(CGP::require_surface, flat_triangle(radians / 2)), "");  // two such angles
  EXPECT_EQ(complaint(CGP::require_surface, flat_triangle(1 / radians)), "");  // one
}

TEST(Require_positive_areas, is_the_same_for_any_unit_of_length)
{
  for (double size : {1e-300, 1e-150, 1e150, 1e300}) {
    EXPECT_EQ(complaint(CGP::require_surface, scaled(icosphere(2), size)), "") << size;
    EXPECT_EQ(complaint(CGP::require_surface, scaled(flat_triangle(1e-8), size)), "") << size;
    EXPECT_NE(complaint(CGP::require_surface, scaled(flat_triangle(1e-14), size)), "") << size;
  }
}

TEST(Require_closed, counts_boundary_edges)
{
  EXPECT_EQ(complaint(CGP::require_closed, icosphere(1)), "");
  EXPECT_EQ(complaint(CGP::require_closed, unit_square()),
            "4 boundary edges, the first is edge 0-1; a closed surface is needed");
  EXPECT_EQ(complaint(CGP::require_closed, without_face(tetrahedron(), 3)),
            "3 boundary edges, the first is edge 1-2; a closed surface is needed");
}

TEST(Require_manifold, lets_faces_have_area_zero)
{
  EXPECT_EQ(complaint(CGP::require_manifold, flat_triangle(0)), "");
  EXPECT_NE(complaint(CGP::require_surface, flat_triangle(0)), "");
  EXPECT_EQ(complaint(CGP::require_manifold, Mesh_view()), "the mesh has no faces");
}

TEST(Require_some_area, refuses_surfaces_that_are_a_line)
{
  EXPECT_EQ(complaint(CGP::require_some_area, flat_triangle(0)),
            "all faces have area zero; a surface is needed");
  EXPECT_EQ(complaint(CGP::require_some_area, flat_triangle(1e-8)), "");
  const Mesh_view both = disjoint_union(flat_triangle(0), flat_triangle(1), {0, 0, 5});
  EXPECT_TRUE(CGP::has_area_zero(both, 0));
  EXPECT_FALSE(CGP::has_area_zero(both, 1));
  EXPECT_EQ(complaint(CGP::require_some_area, both), "");
}

TEST(Require_genus_zero, counts_handles)
{
  EXPECT_EQ(complaint(CGP::require_genus_zero, icosphere(1)), "");
  EXPECT_EQ(complaint(CGP::require_genus_zero, btorus(6)),
            "the surface has genus 1; genus zero is needed");
}

TEST(Requirements, look_for_defects_that_are_counted)
{
  const Mesh_view two = disjoint_union(tetrahedron(), tetrahedron(), {5, 0, 0});
  const CGP::internal::Defect further = CGP::internal::further_components(two);
  EXPECT_EQ(further.kind, CGP::internal::Defect::Kind::further_component);
  EXPECT_EQ(further.count, 1);
  EXPECT_EQ(further.first, 4);
  EXPECT_FALSE(CGP::internal::boundary_edges(two));
  const CGP::internal::Defect flat = CGP::internal::faces_of_area_zero(flat_triangle(0));
  EXPECT_EQ(flat.count, 1);
  EXPECT_EQ(flat.first, 0);
  EXPECT_EQ(CGP::internal::boundary_edges(flat_triangle(1)).count, 3);
}

/// triangles over the edge from (0, 0) to (1, 0), with an apex each
CGP::Mesh_view fan(const Eigen::Matrix2Xd& apexes)
{
  CGP::Points p = CGP::Points::Zero(3, 2 + apexes.cols());
  p(0, 1) = 1;
  p.bottomRightCorner(3, apexes.cols()).topRows(2) = apexes;
  CGP::Mesh_view::Corners corners;
  for (int k = 0; k < apexes.cols(); ++k) corners.push_back({0, 1, 2 + k});
  return {p, corners};
}

TEST(Well_shaped_faces, leave_out_the_thinnest_of_at_most_a_twentieth_of_the_area)
{
  Eigen::Matrix2Xd apexes(2, 6);
  apexes << .5, .5, .5, .01, 0, .3,  //
      1, .051, .03, .02, 0, .049;
  const CGP::Mesh_view mesh = fan(apexes);
  for (const double unit : {1., 1e-30, 1e30}) {
    const CGP::internal::Well_shaped_faces sound =
        CGP::well_shaped_faces({unit * mesh.positions(), mesh.corners()});
    ASSERT_EQ(sound.mesh.size_of_faces(), 3);
    EXPECT_EQ(sound.mesh.corners(0), mesh.corners(0));
    EXPECT_EQ(sound.mesh.corners(1), mesh.corners(1));
    EXPECT_EQ(sound.mesh.corners(2), mesh.corners(5));
    EXPECT_EQ(sound.mesh.size_of_vertices(), mesh.size_of_vertices());
    EXPECT_NEAR(sound.share, 1.1 / 1.15, 1e-12);
  }
}

TEST(Well_shaped_faces, are_all_but_those_without_area_where_all_are_thin)
{
  Eigen::Matrix2Xd apexes(2, 3);
  apexes << .5, 2, .5, .01, 0, .01;
  const CGP::internal::Well_shaped_faces sound = CGP::well_shaped_faces(fan(apexes));
  EXPECT_EQ(sound.mesh.size_of_faces(), 2);
  EXPECT_EQ(sound.share, 1);
}

}  // namespace cgp_test::requirements_tests
