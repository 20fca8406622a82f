// Tests examples/conformal/repair/repair.cpp examples/conformal/repair/Corner_fans.cpp
// Tests examples/conformal/repair/separate_fans.cpp examples/conformal/repair/select_faces.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/repair/repair.h"

#include "conformal/input/Defects.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/process/Failure.h"
#include "conformal/report/Outcome.h"
#include "conformal/report/report_input.h"
#include "program/repair_support.h"
#include "program/support.h"
#include "support/spheres.h"

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <nlohmann/json.hpp>

#include <set>

namespace cgp_test::repair_tests {

using namespace program_test;
using namespace conformal;

const std::vector<Point> corners_of_a_fan = {
    {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}};

TEST(Repair, leaves_a_good_surface_as_it_is)
{
  const CGP::Mesh_view mesh = cgp_test::icosphere(1);
  const Repaired r = repaired(off(mesh));
  EXPECT_FALSE(r.done.has_changed_anything());
  EXPECT_TRUE(r.done.notes().empty());
  EXPECT_EQ(r.input.mesh.corners(), mesh.corners());
  for (std::size_t v = 0; v < r.done.new_vertex.size(); ++v)
    EXPECT_EQ(r.done.new_vertex[v], static_cast<int>(v));
}

TEST(Repair, merges_triangles_that_have_corners_of_their_own)
{
  const CGP::Mesh_view mesh = cgp_test::icosahedron();
  std::vector<Point> points;
  std::vector<std::vector<int>> faces;
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    const Eigen::Vector3d p = mesh.position(mesh.from(h));
    if (h % 3 == 0) faces.emplace_back();
    faces.back().push_back(h);
    points.push_back({p.x(), p.y(), p.z()});
  }
  const Repaired r = repaired(off_of(points, faces));
  EXPECT_EQ(r.done.merged_points, 60 - 12);
  EXPECT_EQ(CGP::topology(r.input.mesh).genus, 0);
  EXPECT_TRUE(CGP::topology(r.input.mesh).is_closed());
  for (int h = 0; h < 60; ++h) {
    const int now = r.done.new_vertex[static_cast<std::size_t>(h)];
    EXPECT_EQ(r.input.file.points[static_cast<std::size_t>(now)],
              parse_surface(off_of(points, faces), "a.off").points[static_cast<std::size_t>(h)]);
  }
}

TEST(Repair, removes_faces_without_three_corners_and_repeated_ones)
{
  // The last two points coincide with the first, so that one face is an edge and one is repeated.
  std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}};
  const Repaired r = repaired(off_of(points, {{0, 3, 1}, {0, 1, 2}, {2, 4, 1}}));
  EXPECT_EQ(r.done.removed_faces, 2);
  EXPECT_EQ(r.done.face_in_file, std::vector<int>{1});
  EXPECT_EQ(r.done.new_face, (std::vector<int>{-1, 0, -1}));
  EXPECT_EQ(r.input.mesh.size_of_faces(), 1);
}

TEST(Repair, keeps_the_polygon_that_is_left_of_a_larger_one)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Repaired r = repaired(off_of(points, {{0, 1, 2, 3, 4}}));
  ASSERT_EQ(r.input.file.polygons.size(), 1u);
  EXPECT_EQ(r.input.file.polygons.degree(0), 4u);
}

TEST(Repair, removes_faces_that_have_less_than_three_corners_in_the_file)
{
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string facet = "facet normal 0 0 1\nouter loop\n";
  const std::string end = "endloop\nendfacet\n", o = "vertex 0 0 0\n", x = "vertex 1 0 0\n";
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty "
      "float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
  const std::string faces = "3 0 0 1\n3 0 1 2\n2 0 1\n4 0 1 0 2\n";
  const std::pair<const char*, std::string> files[] = {
      {"a.off", "OFF\n3 4 0\n" + points + faces},
      {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 1 2\nf 1 2 3\nf 1 2\nf 1 2 1 3\n"},
      {"a.ply", header + points + faces},
      {"a.stl", "solid\n" + facet + o + o + x + end + facet + o + x + "vertex 0 1 0\n" + end +
                    facet + o + x + x + end + facet + x + o + x + end + "endsolid\n"}};
  for (const auto& [name, text] : files) {
    EXPECT_THROW(parse_surface(text, name), Read_error) << name;
    const Repaired r = repaired(text, name);
    EXPECT_EQ(r.done.removed_faces, 3) << name;
    EXPECT_EQ(r.done.new_face, (std::vector<int>{-1, 0, -1, -1})) << name;
    EXPECT_EQ(faces_of(r.input.file), (Faces{{0, 1, 2}})) << name;
  }
}

TEST(Repair, shortens_a_polygon_that_has_a_corner_twice_in_a_row)
{
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
  const Repaired r = repaired(off_of(points, {{0, 1, 1, 2, 0}}));
  EXPECT_EQ(r.done.shortened_faces, 1);
  EXPECT_EQ(r.done.removed_faces, 0);
  EXPECT_EQ(r.done.notes().size(), 1u);
  EXPECT_EQ(faces_of(r.input.file), (Faces{{0, 1, 2}}));
}

TEST(Repair, cuts_a_polygon_that_a_bridge_joins_to_its_hole)
{
  const std::vector<Point> points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0},
                                     {1, 1, 0}, {1, 2, 0}, {2, 1, 0}};
  const Repaired r = repaired(off_of(points, {{0, 1, 2, 0, 3, 4, 5, 3}}));
  EXPECT_EQ(r.done.bridged_faces, 1);
  EXPECT_EQ(r.done.removed_faces + r.done.shortened_faces, 0);
  EXPECT_EQ(r.done.new_face, (std::vector<int>{0}));
  EXPECT_EQ(r.done.notes().size(), 1u);
  EXPECT_DOUBLE_EQ(CGP::total_area(r.input.mesh), 7.5);
  EXPECT_EQ(CGP::topology(r.input.mesh).boundary_loops, 2);
  const Repaired spur = repaired(off_of(points, {{0, 1, 2}, {0, 3, 0, 4}}));
  EXPECT_EQ(spur.done.removed_faces, 1);
  EXPECT_EQ(spur.done.bridged_faces, 0);
}

TEST(Repair, is_reported_with_numbers_that_are_integers)
{
  Repaired r = repaired(off_of(corners_of_a_fan, {{0, 3, 1}, {0, 3, 2}, {3, 0, 4}}));
  r.input.repair = r.done;
  Outcome outcome;
  report_input(r.input, outcome.report);
  const auto json = nlohmann::json::parse(to_json(outcome))["input"]["repair"];
  for (const char* name : {"new_vertex", "new_face", "vertex_in_file", "face_in_file"}) {
    EXPECT_GT(json[name].size(), 0u) << name;
    for (const auto& number : json[name]) EXPECT_TRUE(number.is_number_integer()) << name;
  }
}

TEST(Repair, cuts_where_three_faces_meet)
{
  const Repaired r = repaired(off_of(corners_of_a_fan, {{0, 3, 1}, {0, 3, 2}, {3, 0, 4}}));
  EXPECT_EQ(r.done.cut_edges, 1);
  EXPECT_EQ(r.done.added_vertices, 4);
  EXPECT_EQ(r.done.vertex_in_file, (std::vector<int>{0, 1, 2, 3, 4, 0, 3, 3, 0}));
  EXPECT_TRUE(find_defects(r.input).of_topology.empty());
}

TEST(Repair, cuts_at_a_vertex_where_two_surfaces_touch)
{
  // Two tetrahedra with one corner in common.
  const std::vector<Point> points = {{0, 0, 0},  {1, 0, 0},  {0, 1, 0}, {0, 0, 1},
                                     {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  const Repaired r = repaired(off_of(
      points,
      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}}));
  EXPECT_EQ(r.done.cut_edges, 0);
  EXPECT_EQ(r.done.added_vertices, 1);
  const Defects defects = find_defects(r.input);
  EXPECT_TRUE(defects.of_topology.empty());
  EXPECT_FALSE(defects.of_components.empty());
}

TEST(Repair, cuts_a_moebius_strip_open)
{
  std::vector<Point> points;
  std::vector<std::vector<int>> faces;
  const int n = 12;
  for (int i = 0; i < n; ++i)
    for (const double side : {-.3, .3}) {
      const double u = 2 * std::acos(-1.) * i / n, r = 1 + side * std::cos(u / 2);
      points.push_back({r * std::cos(u), r * std::sin(u), side * std::sin(u / 2)});
    }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = a + 1, c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    faces.push_back({a, c, b});
    faces.push_back({b, c, d});
  }
  const Repaired r = repaired(off_of(points, faces));
  EXPECT_EQ(r.done.cut_edges, 1);
  EXPECT_EQ(r.done.added_vertices, 2);
  EXPECT_TRUE(find_defects(r.input).first().empty());
  EXPECT_EQ(CGP::topology(r.input.mesh).boundary_loops, 1);
  EXPECT_EQ(CGP::topology(r.input.mesh).genus, 0);
}

TEST(Repair, removes_vertices_without_a_face)
{
  const Repaired r = repaired(off(cgp_test::icosahedron(), "9 9 9\n8 8 8\n", 2));
  EXPECT_EQ(r.done.removed_vertices, 2);
  EXPECT_EQ(r.input.unreferenced, 0);
}

TEST(Repair, keeps_properties_and_texture_with_what_they_belong_to)
{
  // Vertices 1 and 2 coincide and have texture coordinates of their own; vertex 0 has no face.
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
      "property double z\nproperty int number\nproperty float u\nproperty float v\n"
      "element face 2\nproperty list uchar int vertex_indices\nproperty int kind\nend_header\n"
      "5 5 5 10 0 0\n0 0 0 11 .1 .2\n0 0 0 12 .3 .4\n1 0 0 13 .5 .6\n0 1 0 14 .7 .8\n"
      "3 1 2 3 7\n3 2 3 4 8\n";
  const Repaired r = repaired(text, "a.ply");
  const Property* number = find_property(r.input.file.vertices, "number");
  const Property* kind = find_property(r.input.file.faces, "kind");
  ASSERT_TRUE(number != nullptr && kind != nullptr);
  ASSERT_EQ(number->rows(), 3u);
  EXPECT_EQ(number->integer(0), 11);
  EXPECT_EQ(number->integer(2), 14);
  ASSERT_EQ(kind->rows(), 1u);
  EXPECT_EQ(kind->integer(0), 8);
  ASSERT_EQ(r.input.file.texture.index.size(), 3u);
  const auto& row =
      r.input.file.texture.values[static_cast<std::size_t>(r.input.file.texture.index.front())];
  EXPECT_NEAR(row[0], .3, 1e-6);  // of vertex 2, though its place is vertex 1's now
}

TEST(Repair, of_a_good_file_changes_no_bit)
{
  // a texture in a list of the faces, a polygon, an element of another kind
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 5\nproperty double x\nproperty double y\n"
      "property double z\nelement face 2\nproperty list uchar int vertex_indices\n"
      "property list uchar float texcoord\nelement edge 1\nproperty int vertex1\n"
      "property int vertex2\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n"
      "4 0 1 2 3 8 0 0 1 0 1 1 0 1\n3 1 4 2 6 0 0 1 0 1 1\n0 1\n";
  const Surface_file before = parse_surface(text, "a.ply");
  Surface_file after = before;
  EXPECT_FALSE(repair(after).has_changed_anything());
  EXPECT_EQ(after.points, before.points);
  EXPECT_EQ(faces_of(after), faces_of(before));
  EXPECT_TRUE(after.texture.empty());
  EXPECT_EQ(after.other_elements.size(), 1u);
  EXPECT_TRUE(after.notes.empty());
  const Property* texture = find_property(after.faces, "texcoord");
  ASSERT_NE(texture, nullptr);
  EXPECT_EQ(texture->count(0), 8u);
}

TEST(Repair, refuses_what_would_leave_no_face)
{
  const std::string line = off_of({{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0, 1, 2}});
  EXPECT_THROW(repaired(line), Failure);
  const std::string point = off_of({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}});
  EXPECT_THROW(repaired(point), Failure);
}

TEST(Repair, of_a_repaired_file_changes_nothing_more)
{
  Surface_file file =
      parse_surface(off_of(corners_of_a_fan, {{0, 3, 1}, {0, 3, 2}, {3, 0, 4}}), "a.off");
  repair(file);
  const Surface_file once = file;
  repair(file);  // separates again the vertices that it has merged
  EXPECT_EQ(file.points, once.points);
  EXPECT_EQ(file.polygons.corners, once.polygons.corners);
}

}  // namespace cgp_test::repair_tests
