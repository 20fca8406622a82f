// Tests examples/conformal/input/Surface_input.cpp examples/conformal/repair/orientation.cpp
// Tests examples/conformal/repair/triangulation.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/input/Surface_input.h"

#include "conformal/repair/triangulation.h"
#include "program/support.h"
#include "support/polyhedra.h"
#include "support/spheres.h"

#include "conformal/io/read_surface.h"

#include <Conformal_geometry_processing/measure/energies.h>

namespace cgp_test::surface_input_tests {

using namespace program_test;
using namespace conformal;

double area_of(const std::string& text)
{
  return CGP::total_area(prepare(parse_surface(text, "a.off")).mesh);
}

TEST(Triangulation, respects_dents)
{
  // an arrow, whose fan from its first corner would cover more than it
  EXPECT_NEAR(area_of("OFF\n4 1 0\n2 0 0\n0 1 0\n1 0 0\n0 -1 0\n4 0 1 2 3\n"), 1, 1e-12);
  // a comb
  EXPECT_NEAR(area_of("OFF\n8 1 0\n0 0 3\n5 0 3\n5 4 3\n4 4 3\n4 1 3\n1 1 3\n1 4 3\n0 4 3\n"
                      "8 0 1 2 3 4 5 6 7\n"),
              11, 1e-12);
}

TEST(Triangulation, keeps_the_orientation_and_names_the_polygon)
{
  const auto t = triangulate(parse_surface(
      "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n4 0 1 2 3\n3 0 4 1\n", "a.off"));
  EXPECT_EQ(t.face_in_file, (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(t.triangulated, 1);
}

TEST(Triangulation, of_a_polygon_that_crosses_itself_ends)
{
  const auto t = triangulate(parse_surface(
      "OFF\n5 1 0\n0 1 0\n0.6 -0.8 0\n-0.9 0.3 0\n0.9 0.3 0\n-0.6 -0.8 0\n5 0 1 2 3 4\n", "a.off"));
  EXPECT_EQ(t.corners.size(), 3u);
}

TEST(Orientation, turns_the_fewer_faces_in_the_file_too)
{
  auto corners = cgp_test::icosphere(1).corners();
  const auto wanted = corners;
  for (const std::size_t f : {3u, 17u, 40u}) std::swap(corners[f][1], corners[f][2]);
  const Surface_input input =
      prepare(parse_surface(off({cgp_test::icosphere(1).positions(), corners}), "a.off"));
  EXPECT_TRUE(input.is_orientable);
  EXPECT_EQ(input.turned_faces, 3);
  EXPECT_GT(CGP::signed_volume(input.mesh), 0);
  EXPECT_EQ(input.notes,
            std::vector<std::string>{"3 faces of 80 turned around, to agree with the others"});
  // the faces of the file are those that were wanted, up to a rotation
  for (std::size_t f = 0; f < wanted.size(); ++f) {
    auto face =
        std::vector<int>(input.file.polygons.corners.begin() + static_cast<long>(3 * f),
                         input.file.polygons.corners.begin() + static_cast<long>(3 * f + 3));
    std::rotate(face.begin(), std::find(face.begin(), face.end(), wanted[f][0]), face.end());
    EXPECT_EQ(face, std::vector<int>(wanted[f].begin(), wanted[f].end()));
  }
}

TEST(Orientation, takes_texture_coordinates_along)
{
  const Surface_input input = prepare(parse_surface(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 1\n"
      "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 2/2 3/3 5/5\n",
      "a.obj"));
  EXPECT_EQ(input.turned_faces, 1);
  EXPECT_EQ(input.file.texture.index, input.file.polygons.corners);
}

TEST(Surface_input, is_inside_out_however_small)
{
  for (const double size : {1., 1e-120}) {
    const auto mesh =
        cgp_test::with_reversed_faces(cgp_test::scaled(cgp_test::icosahedron(), size));
    EXPECT_TRUE(prepare(parse_surface(off(mesh), "a.off")).is_turned_outward);
  }
}

TEST(Surface_input, leaves_vertices_without_faces_out)
{
  const Surface_input input =
      prepare(parse_surface(off(cgp_test::icosahedron(), "9 9 9\n8 8 8\n", 2), "a.off"));
  EXPECT_EQ(input.unreferenced, 2);
  EXPECT_EQ(input.mesh.size_of_vertices(), 12);
  EXPECT_EQ(name_of_vertex(input, 0), "vertex 2");
  EXPECT_EQ(to_file_vertices(input, Eigen::VectorXd::Ones(12), 5)[1], 5);
}

class Seams : public Program {};

/// a tetrahedron whose faces have corners of their own, as seams of texture coordinates cut it
TEST_F(Seams, are_noted_wherever_a_surface_is_read)
{
  const CGP::Mesh_view mesh = cgp_test::tetrahedron();
  CGP::Points points(3, 12);
  CGP::Mesh_view::Corners corners(4);
  for (int c = 0; c < 12; ++c) {
    points.col(c) = mesh.position(mesh.corners(c / 3)[static_cast<std::size_t>(c % 3)]);
    corners[static_cast<std::size_t>(c / 3)][static_cast<std::size_t>(c % 3)] = c;
  }
  write("a.off", off({points, corners}));
  const std::string note = "8 vertices at the boundary on others; --repair merges them";
  EXPECT_NE(run("info a.off").err.find(note), std::string::npos);
  EXPECT_NE(run("split a.off -o b.off").err.find(note), std::string::npos);
  EXPECT_TRUE(fails(run("info a.off --advanced strict"), 4, note));
  const Program_run repaired = run("info a.off --repair");
  EXPECT_EQ(repaired.err.find(note), std::string::npos) << repaired.err;
  EXPECT_NE(repaired.err.find("8 vertices merged"), std::string::npos) << repaired.err;
}

}  // namespace cgp_test::surface_input_tests
