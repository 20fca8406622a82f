// Tests examples/conformal/io/obj/read_obj.cpp examples/conformal/io/data/Left_out.cpp
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

/// the only note on a triangle with more lines
std::string note(const std::string& lines, const std::string& face = "f 1 2 3\n")
{
  const Surface_file file = parse_obj(points + lines + face, "a.obj");
  EXPECT_EQ(file.points.size(), 4u) << lines;
  EXPECT_EQ(corners(file, 0), (std::vector<int>{0, 1, 2})) << lines;
  return file.notes.size() == 1 ? file.notes[0] : std::to_string(file.notes.size()) + " notes";
}

TEST(Read_obj, leaves_out_colours_that_not_all_vertices_have)
{
  const Surface_file file = parse_obj("v 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n", "a.obj");
  EXPECT_TRUE(file.vertices.properties.empty());
  EXPECT_EQ(file.notes, (std::vector<std::string>{
                            "left out: colours, which not all vertices have (1, first: line 2)"}));
}

TEST(Read_obj, leaves_out_weights_and_values_that_are_no_colours)
{
  const auto notes = [](const std::string& more) {
    return parse_obj("v 0 0 0 1\nv 1 0 0" + more + "\nv 0 1 0\nf 1 2 3\n", "a.obj").notes;
  };
  const std::vector<std::string> left_out = {
      "left out: values of vertices that are not colours (1, first: line 2)"};
  EXPECT_TRUE(notes(" 1.0").empty());
  for (const char* more : {" 0.5", " nan", " 1 1", " x", " 1 x 3"})
    EXPECT_EQ(notes(more), left_out) << more;
}

TEST(Read_obj, leaves_out_values_of_attributes_that_are_not_as_they_should_be)
{
  EXPECT_EQ(note("vt 0 0 0 1\n"), "left out: values after texture coordinates (1, first: line 5)");
  EXPECT_EQ(note("vt 0 0 extra\n"), note("vt 0 0 0 1\n"));
  EXPECT_EQ(note("vn 1 2 3 4\n"), "left out: values after normals (1, first: line 5)");
}

TEST(Read_obj, leaves_out_indices_of_attributes_that_are_not_there)
{
  const std::string none = "left out: texture indices without coordinates (3, first: line ";
  EXPECT_EQ(note("", "f 1/1 2/2 3/3\n"), none + "5)");
  EXPECT_EQ(note("vt\n", "f 1/1 2/1 3/1\n"), none + "6)");  // a row, but without values
  EXPECT_EQ(note("vn 1 2\n", "f 1//1 2//1 3//1\n"),
            "left out: normal indices without a normal (3, first: line 6)");
  EXPECT_EQ(note("", "f 1/0 2/-1 3/x\n"),
            "left out: indices of corners that are none (3, first: line 5)");
  EXPECT_EQ(note("", "f 1 2 3///9\n"), "left out: further indices of corners (1, first: line 5)");
}

TEST(Read_obj, leaves_out_unknown_statements_with_the_first_line_of_each)
{
  EXPECT_EQ(note("t crease 2/1/0 1 2 3.5\nt \\\n v 1 2 3\n"),
            "left out: 't' statements (2, first: line 5)");
  std::string many;
  for (char c = 'A'; c <= 'Z'; ++c) many += std::string(1, c) + " 1 2 3\n";
  EXPECT_EQ(note(many), "11 notes");  // ten, and the rest
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
  const Surface_file file = parse_obj(text, "a.obj");
  EXPECT_EQ(file.polygons.size(), 1u);
  EXPECT_EQ(file.notes.size(), 4u);
}

TEST(Read_obj, refuses_bad_vertices_with_their_line)
{
  EXPECT_EQ(refusal("v 0 0\nv 1 0 0\n"), "a.obj:1: the line ends, wanted a coordinate");
  EXPECT_EQ(refusal("\nv 0 0 inf\n"), "a.obj:2: 'inf' is not finite, wanted a coordinate");
  EXPECT_EQ(refusal("v 0 0 x\n"), "a.obj:1: 'x' is not a number, wanted a coordinate");
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
  for (const char* index : {"0", "-5", "2147483648"})
    EXPECT_EQ(refusal(with(std::string("f 1 2 ") + index)),
              std::string("a.obj:6: the index ") + index + ", wanted 1 to 2147483647, or -4 to -1");
  EXPECT_EQ(refusal(with("f 1 2 2")),
            "a.obj:6: a face has the vertex 2 twice, wanted different corners; try: --repair");
}

TEST(Read_obj, refuses_what_has_no_surface)
{
  EXPECT_EQ(refusal(points), "a.obj:5: no faces, wanted a surface");
  EXPECT_EQ(refusal("# nothing\n"), "a.obj:2: no vertices, wanted a surface");
}

}  // namespace cgp_test::read_obj_tests
