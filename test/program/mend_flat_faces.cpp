// Tests examples/conformal/repair/mend_flat_faces.cpp examples/conformal/repair/Flatness.cpp
// Tests examples/conformal/repair/Triangle_soup.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/repair/mend_flat_faces.h"

#include "conformal/input/Defects.h"
#include "program/repair_support.h"
#include "support/spheres.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace cgp_test::mend_flat_faces_tests {

using namespace program_test;
using namespace conformal;

std::vector<Point> points_of(const CGP::Mesh_view& mesh)
{
  std::vector<Point> points;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    points.push_back({p.x(), p.y(), p.z()});
  }
  return points;
}

Faces faces_of_view(const CGP::Mesh_view& mesh)
{
  Faces faces;
  for (const auto& v : mesh.corners()) faces.push_back({v[0], v[1], v[2]});
  return faces;
}

/// Vertex 2 lies on the edge from 0 to 1, and face 1 fills nothing.
const std::vector<Point> points_with_cap = {{0, 0, 0}, {4, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}};
const Faces faces_with_cap = {{0, 1, 3}, {1, 0, 2}, {2, 0, 4}, {1, 2, 4}};

/// A strip above and below the segment from 0 to n, with n - 1 caps between from its first point.
std::pair<std::vector<Point>, Faces> row_of_caps(int n, bool last_first)
{
  std::vector<Point> points;
  for (int i = 0; i <= n; ++i) points.push_back({i / 10., i / 5., 0});
  points.push_back({-1, 1, 0});
  points.push_back({1, -1, 0});
  Faces faces = {{0, n, n + 1}};
  for (int i = 1; i < n; ++i) faces.push_back({0, i, i + 1});
  if (last_first) std::reverse(faces.begin() + 1, faces.end());
  for (int i = 0; i < n; ++i) faces.push_back({i + 1, i, n + 2});
  return {points, faces};
}

double area(const Surface_input& input)
{
  double sum = 0;
  for (int f = 0; f < input.mesh.size_of_faces(); ++f)
    sum += input.mesh.double_area_vector(f).norm() / 2;
  return sum;
}

TEST(Mend_flat_faces, flips_the_edge_opposite_the_obtuse_corner)
{
  const Repaired r = repaired(off_of(points_with_cap, faces_with_cap));
  EXPECT_EQ(r.done.flipped_edges, 1);
  EXPECT_EQ(faces_of(r.input.file), (Faces{{3, 0, 2}, {2, 1, 3}, {2, 0, 4}, {1, 2, 4}}));
  EXPECT_EQ(r.input.file.points, points_with_cap);
  EXPECT_EQ(r.done.face_in_file, (std::vector<int>{0, 0, 2, 3}));
  EXPECT_EQ(r.done.new_face, (std::vector<int>{0, -1, 2, 3}));
  EXPECT_EQ(r.done.notes().size(), 1u);
}

TEST(Mend_flat_faces, mends_rows_of_caps_one_after_the_other)
{
  for (const bool last_first : {false, true}) {
    const auto [points, faces] = row_of_caps(7, last_first);
    const Repaired r = repaired(off_of(points, faces));
    EXPECT_TRUE(find_defects(r.input).first().empty()) << find_defects(r.input).first();
    EXPECT_GE(r.done.flipped_edges, 6);
    EXPECT_EQ(r.done.collapsed_edges + r.done.removed_flat_faces, 0);
    EXPECT_EQ(r.input.file.points, points);
    EXPECT_EQ(r.input.mesh.size_of_faces(), static_cast<int>(faces.size()));
    EXPECT_NEAR(area(r.input), area(prepare(parse_surface(off_of(points, faces), "a.off"))), 1e-14);
  }
}

TEST(Mend_flat_faces, removes_a_cap_at_the_boundary)
{
  const Faces faces(faces_with_cap.begin() + 1, faces_with_cap.end());
  std::vector<Point> points = points_with_cap;
  points.erase(points.begin() + 3);
  const Repaired r = repaired(off_of(points, {{1, 0, 2}, {2, 0, 3}, {1, 2, 3}}));
  EXPECT_EQ(r.done.removed_flat_faces, 1);
  EXPECT_EQ(r.done.removed_triangles, (std::vector<std::array<int, 3>>{{1, 0, 2}}));
  EXPECT_EQ(r.done.new_face, (std::vector<int>{-1, 0, 1}));
  EXPECT_EQ(faces_of(r.input.file), (Faces{{2, 0, 3}, {1, 2, 3}}));
  EXPECT_EQ(r.input.file.points, points);
}

TEST(Mend_flat_faces, removes_a_cap_where_three_faces_meet)
{
  std::vector<Point> points = points_with_cap;
  points.push_back({1, 0, 1});
  Faces faces = faces_with_cap;
  faces.push_back({1, 0, 5});
  const Repaired r = repaired(off_of(points, faces));
  EXPECT_EQ(r.done.removed_flat_faces, 1);
  EXPECT_EQ(r.done.cut_edges, 0);  // the two that are left go together
  EXPECT_TRUE(find_defects(r.input).of_geometry.empty());
  EXPECT_TRUE(find_defects(r.input).of_topology.empty());
}

TEST(Mend_flat_faces, collapses_where_the_other_diagonal_exists)
{
  // A vertex in the first face of the icosahedron, moved beyond a corner on the line of an edge.
  const CGP::Mesh_view sphere = cgp_test::icosahedron();
  std::vector<Point> points = points_of(sphere);
  Faces faces = faces_of_view(sphere);
  const int b = faces[0][0], c = faces[0][1], d = faces[0][2], a = 12;
  const Eigen::Vector3d p = 1.5 * sphere.position(c) - 0.5 * sphere.position(b);
  points.push_back({p.x(), p.y(), p.z()});
  faces[0] = {a, b, c};
  faces.push_back({a, c, d});
  faces.push_back({a, d, b});
  const Repaired r = repaired(off_of(points, faces));
  EXPECT_EQ(r.done.flipped_edges, 0);
  EXPECT_EQ(r.done.collapsed_edges, 1);
  EXPECT_NEAR(r.done.longest_collapsed_edge, 0.5 * (sphere.position(c) - sphere.position(b)).norm(),
              1e-15);
  EXPECT_EQ(r.done.new_vertex[12], c);
  EXPECT_EQ(r.done.merged_points, 0);
  EXPECT_EQ(r.done.removed_vertices, 0);
  EXPECT_EQ(r.input.file.points, points_of(sphere));
  faces = faces_of_view(sphere);
  faces.erase(faces.begin());
  faces.push_back({c, d, b});
  EXPECT_EQ(faces_of(r.input.file), faces);
}

TEST(Mend_flat_faces, collapses_needles_that_cannot_be_flipped)
{
  // One vertex is two that are next to each other, with a needle on either side of the new edge.
  const CGP::Mesh_view sphere = cgp_test::icosphere(1);
  std::vector<Point> points = points_of(sphere);
  Faces faces = faces_of_view(sphere);
  int h = 0;
  while (sphere.from(h) != 0) ++h;
  const int x = sphere.to(h), first = h;
  int y = -1;
  for (int step = 0; step < 3; ++step) {
    std::vector<int>& face = faces[static_cast<std::size_t>(CGP::Mesh_view::face(h))];
    std::replace(face.begin(), face.end(), 0, 42);
    h = sphere.twin(CGP::Mesh_view::previous_in_face(h));
    y = sphere.to(h);
  }
  ASSERT_NE(h, first);
  points.push_back(points[0]);
  points.back()[0] += 4e-16;
  points.back()[1] += 4e-16;
  points.back()[2] += 4e-16;
  faces.push_back({0, x, 42});
  faces.push_back({0, 42, y});
  const Repaired r = repaired(off_of(points, faces));
  EXPECT_EQ(r.done.collapsed_edges, 1);
  EXPECT_LT(r.done.longest_collapsed_edge, 1e-15);
  EXPECT_TRUE(find_defects(r.input).first().empty()) << find_defects(r.input).first();
  EXPECT_EQ(r.input.mesh.size_of_vertices(), 42);
  EXPECT_EQ(r.done.new_vertex[0], r.done.new_vertex[42]);
}

TEST(Mend_flat_faces, keeps_texture_coordinates_at_the_corner_that_splits)
{
  const std::string vertices = "v 0 0 0\nv 4 0 0\nv 1 0 0\nv 1 1 0\nv 1 -1 0\n",
                    texture =
                        "vt 0 0\nvt 4 0\nvt 1.5 0\nvt 1 1\nvt 1 -1\nvt 8 0\nvt 12 0\nvt 9 0\n";
  const auto texture_at_2 = [&](const std::string& others) {
    const Repaired r = repaired(vertices + texture + "f 1/1 2/2 4/4\n" + others, "a.obj");
    EXPECT_EQ(r.done.flipped_edges, 1);
    const Corner_values& uv = r.input.file.texture;
    std::vector<double> u;
    for (std::size_t c = 0; c < 6; ++c)
      if (r.input.file.polygons.corners[c] == 2)
        u.push_back(uv.values[static_cast<std::size_t>(uv.index[c])][0]);
    return u;
  };
  const std::string same = "f 2/2 1/1 3/3\nf 3/3 1/1 5/5\nf 2/2 3/3 5/5\n";
  EXPECT_EQ(texture_at_2(same), (std::vector<double>{1.5, 1.5}));  // its own
  const std::string seam = "f 2/7 1/6 3/8\nf 3/8 1/6 5/5\nf 2/7 3/8 5/5\n";
  EXPECT_EQ(texture_at_2(seam), (std::vector<double>{1, 1}));  // a quarter of the way from 0 to 4
  const std::string none = "f 2 1 3\nf 3 1 5\nf 2 3 5\n";
  EXPECT_EQ(texture_at_2(none), (std::vector<double>{1, 1}));
}

TEST(Mend_flat_faces, gives_both_parts_the_properties_of_the_face_that_was_split)
{
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
      "property double z\nelement face 4\nproperty list uchar int vertex_indices\n"
      "property int kind\nend_header\n0 0 0\n4 0 0\n1 0 0\n1 1 0\n1 -1 0\n"
      "3 0 1 3 7\n3 1 0 2 8\n3 2 0 4 9\n3 1 2 4 10\n";
  const Repaired r = repaired(text, "a.ply");
  const Property* kind = find_property(r.input.file.faces, "kind");
  ASSERT_TRUE(kind != nullptr && kind->rows() == 4);
  EXPECT_EQ(kind->integer(0), 7);
  EXPECT_EQ(kind->integer(1), 7);
  EXPECT_EQ(kind->integer(2), 9);
}

TEST(Mend_flat_faces, keeps_group_lines_before_the_faces_they_preceded)
{
  const Repaired r = repaired(
      "v 0 0 0\nv 4 0 0\nv 1 0 0\nv 1 1 0\nv 1 -1 0\ng top\nf 1 2 4\ng cap\nf 2 1 3\n"
      "g bottom\nf 3 1 5\nf 2 3 5\n",
      "a.obj");
  ASSERT_EQ(r.input.file.group_lines.size(), 3u);
  EXPECT_EQ(r.input.file.group_lines[0].face, 0u);
  EXPECT_EQ(r.input.file.group_lines[2].face, 2u);
}

TEST(Mend_flat_faces, cuts_only_the_polygons_that_take_part)
{
  const std::vector<Point> points = {{0, 0, 0}, {4, 0, 0},  {1, 0, 0}, {4, 1, 0},
                                     {0, 1, 0}, {1, -1, 0}, {0, 2, 0}, {4, 2, 0}};
  const Repaired r =
      repaired(off_of(points, {{4, 3, 7, 6}, {0, 1, 3, 4}, {1, 0, 2}, {2, 0, 5}, {1, 2, 5}}));
  EXPECT_EQ(r.done.flipped_edges, 1);
  EXPECT_EQ(r.done.cut_polygons, 1);
  EXPECT_EQ(r.done.face_in_file, (std::vector<int>{0, 1, 1, 1, 3, 4}));
  EXPECT_EQ(r.input.file.polygons.degree(0), 4u);
  EXPECT_TRUE(find_defects(r.input).first().empty());
}

TEST(Mend_flat_faces, removes_a_component_without_area)
{
  const CGP::Mesh_view sphere = cgp_test::icosahedron();
  std::vector<Point> points = points_of(sphere);
  Faces faces = faces_of_view(sphere);
  for (const double x : {2., 3., 5., 9.}) points.push_back({x, x, x});
  for (const auto& face : Faces{{12, 13, 14}, {13, 12, 15}, {14, 15, 12}, {15, 14, 13}})
    faces.push_back(face);
  const Repaired r = repaired(off_of(points, faces));
  EXPECT_EQ(r.done.removed_flat_faces, 4);
  EXPECT_EQ(r.done.removed_vertices, 4);
  EXPECT_EQ(r.input.mesh.corners(), sphere.corners());
}

TEST(Mend_flat_faces, leaves_what_it_cannot_mend_to_be_named)
{
  // All diagonals of a tetrahedron exist. Number 0 is repeated, and the flat one was number 2.
  const std::vector<Point> points = {{0, 0, 0}, {3, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  Surface_file file = parse_surface(
      off_of(points, {{0, 3, 1}, {0, 3, 1}, {0, 1, 2}, {1, 3, 2}, {2, 3, 0}}), "a.off");
  Repair done = repair(file);
  EXPECT_EQ(done.flipped_edges + done.collapsed_edges + done.removed_flat_faces, 0);
  Surface_input input = prepare(std::move(file));
  input.repair = std::move(done);
  const std::vector<std::string> defects = find_defects(input).of_geometry;
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_NE(defects[0].find("1 face of area zero (first: face 2)"), std::string::npos)
      << defects[0];
}

TEST(Mend_flat_faces, mends_at_any_scale)
{
  for (const double scale : {1e-200, 1e-9, 1e9, 1e200}) {
    std::vector<Point> points = points_with_cap;
    for (Point& p : points)
      for (double& x : p) x *= scale;
    EXPECT_EQ(repaired(off_of(points, faces_with_cap)).done.flipped_edges, 1) << scale;
  }
}

}  // namespace cgp_test::mend_flat_faces_tests
