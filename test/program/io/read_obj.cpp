// Tests examples/conformal/io/obj/read_obj.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/obj/read_obj.h"

#include "program/io/io_support.h"

#include <cmath>

namespace cgp_test::read_obj_tests {

using namespace conformal;
using namespace io_test;

const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\n";

std::string refusal(const std::string& text)
{
  return message_of([&] { parse_obj(text, "a.obj"); });
}

TEST(Read_obj, reads_points_and_faces_as_they_are)
{
  const Surface_file file = parse_obj(points + "f 1 2 3\nf 1 3 4\n", "a.obj");
  EXPECT_EQ(file.format, File_format::obj);
  EXPECT_EQ(file.points[3], (Point{0, 1, 0.5}));
  EXPECT_EQ(corners(file, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(corners(file, 1), (std::vector<int>{0, 2, 3}));
}

TEST(Read_obj, counts_relative_indices_from_the_vertices_so_far)
{
  const Surface_file file = parse_obj(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf -3/-3 -2/-2 -1/-1\nv 9 9 9\nf -4 -3 "
      "-1\n",
      "a.obj");
  EXPECT_EQ(corners(file, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(corners(file, 1), (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(file.texture.index, (std::vector<int>{0, 1, 2, -1, -1, -1}));
}

TEST(Read_obj, joins_lines_that_end_in_a_backslash)
{
  const Surface_file file = parse_obj(points + "f 1 2\\\n 3 \\\r\n4\n", "a.obj");
  EXPECT_EQ(corners(file, 0), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(refusal(points + "f 1 \\\n2 \\\nx\n"),
            "a.obj:7: 'x' is not an index, wanted v, v/vt, v//vn or v/vt/vn");
}

TEST(Read_obj, accepts_faces_before_their_vertices)
{
  EXPECT_EQ(corners(parse_obj("f 1 2 3\n" + points, "a.obj"), 0), (std::vector<int>{0, 1, 2}));
}

TEST(Read_obj, reads_every_form_of_a_corner)
{
  const Surface_file file =
      parse_obj(points + "vt 0.5 0.25\nvt 1\nvn 0 0 2\nf 1/2/1 2//1 3/1\nf 1// 3/ 4\n", "a.obj");
  EXPECT_EQ(file.texture.index, (std::vector<int>{1, -1, 0, -1, -1, -1}));
  EXPECT_EQ(file.normals.index, (std::vector<int>{0, 0, -1, -1, -1, -1}));
  EXPECT_EQ(file.texture.dimension, 2u);
  EXPECT_EQ(file.texture.values[0], (std::array<double, 3>{0.5, 0.25, 0}));
  EXPECT_EQ(file.normals.values[0], (std::array<double, 3>{0, 0, 2}));
}

TEST(Read_obj, keeps_seams)
{
  const Surface_file file = parse_obj(
      points + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 9 9\nf 1/1 2/2 3/3\nf 1/5 3/3 4/4\n", "a.obj");
  EXPECT_EQ(file.texture.index, (std::vector<int>{0, 1, 2, 4, 2, 3}));
}

TEST(Read_obj, keeps_colours_even_if_they_are_not_numbers)
{
  const Surface_file file =
      parse_obj("v 0 0 0 0.5 1 0\nv 1 0 0 nan nan nan\nv 0 1 0 0 0 1\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(types(file.vertices), "red:double green:double blue:double");
  EXPECT_EQ(values(file.vertices, "red")[0], 0.5);
  EXPECT_TRUE(std::isnan(values(file.vertices, "blue")[1]));
}

TEST(Read_obj, accepts_the_weight_one)
{
  EXPECT_EQ(parse_obj("v 0 0 0 1\nv 1 0 0 1.0\nv 0 1 0\nf 1 2 3\n", "a.obj").points.size(), 3u);
  EXPECT_EQ(refusal("v 0 0 0 2\n"), "a.obj:1: a vertex with 4 numbers, wanted 3, 6 or 7");
}

TEST(Read_obj, keeps_groups_materials_and_lines_of_comment)
{
  const Surface_file file =
      parse_obj("#hand made\nmtllib my file.mtl\n" + points +
                    "usemtl red\nf 1 2 3 # first\n# between\ng b\ns off\nf 1 3 4\n",
                "a.obj");
  ASSERT_EQ(file.group_lines.size(), 4u);
  EXPECT_EQ(file.group_lines[0].text, "mtllib my file.mtl");
  EXPECT_EQ(file.group_lines[1].face, 0u);
  EXPECT_EQ(file.group_lines[2].text, "g b");
  EXPECT_EQ(file.group_lines[3].face, 1u);
  EXPECT_EQ(file.comments, (std::vector<std::string>{"hand made", "between"}));
}

TEST(Read_obj, skips_points_lines_and_curves)
{
  const std::string text = points + "p 1\nl 1 2\ncstype bezier\nvp 0 0\nf 1 2 3\n";
  EXPECT_EQ(parse_obj(text, "a.obj").polygons.size(), 1u);
}

TEST(Read_obj, refuses_bad_vertices_with_their_line)
{
  EXPECT_EQ(refusal("v 0 0\nv 1 0 0\n"), "a.obj:1: the line ends, wanted a coordinate");
  EXPECT_EQ(refusal("\nv 0 0 inf\n"), "a.obj:2: 'inf' is not finite, wanted a coordinate");
  EXPECT_EQ(refusal("v 0 0 0 1 1\n"), "a.obj:1: a vertex with 5 numbers, wanted 3, 6 or 7");
  EXPECT_EQ(refusal("v 0 0 0 1 1 1 1 1\n"), "a.obj:1: '1' after a vertex, wanted a new line");
  EXPECT_EQ(refusal("v 0 0 0 1 1 1\nv 0 0 0\n"),
            "a.obj:2: a vertex with 0 numbers for its colour, wanted 3 as before");
  EXPECT_EQ(refusal("vt\n"), "a.obj:1: vt without numbers, wanted texture coordinates");
  EXPECT_EQ(refusal("vt 1 2 3 4\n"), "a.obj:1: '4' after texture coordinates, wanted a new line");
  EXPECT_EQ(refusal("vn 1 2\n"), "a.obj:1: vn with too few numbers, wanted three");
  EXPECT_EQ(refusal("vn 1 2 3 4\n"), "a.obj:1: '4' after a normal, wanted a new line");
}

TEST(Read_obj, refuses_bad_faces_with_their_line)
{
  const auto with = [](const std::string& face) {
    return points + "vt 0 0\n" + face + "\nf 1 2 3\n";
  };
  EXPECT_EQ(refusal(with("f 1// 2//")),
            "a.obj:6: a face of 2 corners, wanted at least 3; try: --repair");
  EXPECT_EQ(refusal(with("f")), "a.obj:6: a face of 0 corners, wanted at least 3; try: --repair");
  EXPECT_EQ(refusal(with("f 1 2 5")), "a.obj:6: a face has the vertex index 5, wanted 1 to 4");
  EXPECT_EQ(refusal(with("f 1 2 0")), "a.obj:6: the index 0, wanted 1 or more, or a negative one");
  EXPECT_EQ(refusal(with("f 1 2 -5")),
            "a.obj:6: the relative index -5, but only 4 stand before it");
  EXPECT_EQ(refusal(with("f 1 2 2")),
            "a.obj:6: a face has the vertex 2 twice, wanted different corners; try: --repair");
  EXPECT_EQ(refusal(with("f 1/1 2/1 3/2")),
            "a.obj:6: a face has the texture index 2, wanted 1 to 1");
  EXPECT_EQ(refusal(with("f 1//1 2 3")), "a.obj:6: a face has the normal index 1, wanted 1 to 0");
  EXPECT_EQ(refusal(with("f 1/1//1 2 3")),
            "a.obj:6: a corner of more than three indices, wanted v/vt/vn");
  EXPECT_EQ(refusal(with("f 2147483648 2 3")),
            "a.obj:6: the index 2147483648 is above 2147483647, the limit");
}

TEST(Read_obj, refuses_what_is_no_word_of_obj_and_what_has_no_surface)
{
  EXPECT_EQ(refusal(points + "F 1 2 3\n"),
            "a.obj:5: 'F' is no word of an OBJ file, wanted v, vt, vn, f, ...");
  EXPECT_EQ(refusal(points), "a.obj:5: no faces, wanted a surface");
  EXPECT_EQ(refusal("# nothing\n"), "a.obj:2: no vertices, wanted a surface");
}

}  // namespace cgp_test::read_obj_tests
