// Tests examples/conformal/io/off/read_off.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/off/read_off.h"

#include "program/io/io_support.h"

#include <cmath>

namespace cgp_test::read_off_tests {

using namespace conformal;
using namespace io_test;

const std::string square = "4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n3 0 1 2\n3 0 2 3\n";

std::string refusal(const std::string& text)
{
  return message_of([&] { parse_off(text, "a.off"); });
}

TEST(Read_off, reads_points_and_faces_as_they_are)
{
  const Surface_file file = parse_off("OFF\n" + square, "a.off");
  EXPECT_EQ(file.format, File_format::off);
  ASSERT_EQ(file.points.size(), 4u);
  EXPECT_EQ(file.points[3], (Point{0, 1, 0.5}));
  ASSERT_EQ(file.polygons.size(), 2u);
  EXPECT_EQ(corners(file, 1), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(file.vertices.size, 4u);
  EXPECT_EQ(file.faces.size, 2u);
}

TEST(Read_off, accepts_every_layout_of_the_header)
{
  const std::string body = square.substr(square.find('\n'));
  for (const std::string header : {"OFF 4 2 0", "\t  OFF4 2 0 # counts",
                                   "# first\n\nOFF # word\n\n4 2 0", "OFF\r\n4 2 0\r", "OFF\n4 2"})
    EXPECT_EQ(parse_off(header + body, "a.off").polygons.size(), 2u) << header;
}

TEST(Read_off, accepts_old_line_ends_and_one_index_per_line)
{
  std::string text = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4\n0\n1\n2\n3\n";
  EXPECT_EQ(corners(parse_off(text, "a.off"), 0), (std::vector<int>{0, 1, 2, 3}));
  for (char& c : text)
    if (c == '\n') c = '\r';
  EXPECT_EQ(corners(parse_off(text, "a.off"), 0), (std::vector<int>{0, 1, 2, 3}));
}

TEST(Read_off, reads_normals_colours_and_texture_coordinates)
{
  const Surface_file file = parse_off(
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 255 0 7 0.25 0.75\n1 0 0 0 0 1 1 2 3 1 0\n0 1 0 0 0 1 4 5 6 0 "
      "1\n"
      "3 0 1 2 0.5 nan 1 0.25\n",
      "a.off");
  EXPECT_EQ(types(file.vertices),
            "nx:double ny:double nz:double red:uchar green:uchar blue:uchar texture_u:double "
            "texture_v:double");
  EXPECT_EQ(values(file.vertices, "red"), (std::vector<double>{255, 1, 4}));
  EXPECT_EQ(values(file.vertices, "texture_v"), (std::vector<double>{0.75, 0, 1}));
  EXPECT_EQ(types(file.faces), "red:double green:double blue:double alpha:double");
  EXPECT_TRUE(std::isnan(values(file.faces, "green")[0]));
}

TEST(Read_off, keeps_colours_of_some_faces_and_indices_of_colours)
{
  const std::string body = "3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 1";
  const Surface_file some = parse_off("OFF\n" + body + "\n", "a.off");
  EXPECT_EQ(types(some.faces), "color:uchar[]");
  EXPECT_EQ(find_property(some.faces, "color")->count(0), 3u);
  EXPECT_EQ(find_property(some.faces, "color")->count(1), 0u);
  EXPECT_EQ(types(parse_off("OFF\n" + body + " 300 0 0\n", "a.off").faces),
            "red:int green:int blue:int");
}

TEST(Read_off, keeps_comments)
{
  const Surface_file file = parse_off("# one\nOFF\n#two\n" + square + "# three", "a.off");
  EXPECT_EQ(file.comments, (std::vector<std::string>{"one", "two", "three"}));
}

TEST(Read_off, accepts_denormal_and_refuses_infinite_coordinates)
{
  const auto with = [](const std::string& x) {
    return "OFF\n3 1 0\n0 0 0\n1 " + x + " 0\n0 1 0\n3 0 1 2\n";
  };
  EXPECT_EQ(parse_off(with("4.9406564584124654e-324"), "a.off").points[1][1], 5e-324);
  for (const std::string x : {"nan", "-inf", "1e400"})
    EXPECT_EQ(refusal(with(x)), "a.off:4: '" + x + "' is not finite, wanted a coordinate");
  EXPECT_EQ(refusal(with("1,5")), "a.off:4: '1,5' is not a number, wanted a coordinate");
}

TEST(Read_off, refuses_other_kinds_of_off_by_name)
{
  EXPECT_EQ(refusal("4OFF\n" + square),
            "a.off:1: 4OFF: points are not in three dimensions, wanted OFF");
  EXPECT_EQ(refusal("nOFF\n3\n" + square),
            "a.off:1: nOFF: points are not in three dimensions, wanted OFF");
  EXPECT_EQ(refusal("OFF BINARY\nxyz"), "a.off:1: OFF BINARY is not supported, wanted ASCII");
  EXPECT_EQ(refusal("{ appearance }"), "a.off:1: '{', wanted the word OFF");
  EXPECT_EQ(refusal(" # nothing\n"), "a.off: has no words, wanted OFF");
}

TEST(Read_off, refuses_counts_that_the_file_cannot_hold_at_once)
{
  EXPECT_EQ(refusal("OFF\n353535235358 1 0\n0 0 0\n"),
            "a.off:2: 353535235358 vertices, but the 7 bytes left hold at most 1");
  EXPECT_EQ(refusal("OFF\n1 2147483648 0\n0 0 0\n"),
            "a.off:2: 2147483648 faces, but the 7 bytes left hold at most 1");
  EXPECT_EQ(refusal("OFF\n-1 1 0\n0 0 0\n"), "a.off:2: -1 vertices, wanted a count");
  EXPECT_EQ(refusal("OFF\n18446744073709551615 1 0\n"),
            "a.off:2: '18446744073709551615' is not an integer, wanted the number of vertices");
  EXPECT_EQ(refusal("OFF\n1 x 0\n"), "a.off:2: 'x' is not an integer, wanted the number of faces");
  EXPECT_EQ(refusal("OFF\n1 1 0 5\n0 0 0\n3 0 0 0\n"),
            "a.off:2: '5' after the three counts, wanted a new line");
  EXPECT_EQ(refusal("OFF\n0 0 0\n"), "a.off:2: no vertices, wanted a surface");
  EXPECT_EQ(refusal("OFF\n1 0 0\n0 0 0\n"), "a.off:2: no faces, wanted a surface");
  EXPECT_EQ(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4294967296 0 1 2\n"),
            "a.off:6: 4294967296 corners, but the 7 bytes left hold at most 4");
}

TEST(Read_off, refuses_bad_faces_with_their_line)
{
  const auto with = [](const std::string& face) {
    return "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n" + face + "\n# end\n";
  };
  EXPECT_EQ(refusal(with("2 0 1")),
            "a.off:6: a face of 2 corners, wanted at least 3; try: --repair");
  EXPECT_EQ(refusal(with("3 0 1 3")), "a.off:6: a face has the vertex index 3, wanted 0 to 2");
  EXPECT_EQ(refusal(with("3 0 -1 2")), "a.off:6: a face has the vertex index -1, wanted 0 to 2");
  EXPECT_EQ(refusal(with("3 0 1 1")),
            "a.off:6: a face has the vertex 1 twice, wanted different corners; try: --repair");
  EXPECT_EQ(refusal(with("3 0 1 2.0")), "a.off:6: '2.0' is not an integer, wanted a vertex index");
  EXPECT_EQ(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1  \n"),
            "a.off:7: the file ends, wanted a vertex index");
}

TEST(Read_off, leaves_out_what_the_header_does_not_announce_with_a_note)
{
  const Surface_file file =
      parse_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 2 1 0\n", "a.off");
  EXPECT_EQ(file.polygons.size(), 1u);
  EXPECT_EQ(file.notes, std::vector<std::string>{"the header announces 1 faces; what follows them, "
                                                 "from line 7 on, was left out"});
}

TEST(Read_off, refuses_a_large_face_with_a_repeated_corner)
{
  std::string text = "OFF\n20 1 0\n", face = "20";
  for (int v = 0; v < 20; ++v) text += std::to_string(v) + " 0 0\n";
  for (int v = 0; v < 20; ++v) face += ' ' + std::to_string(v == 19 ? 4 : v);
  EXPECT_EQ(refusal(text + face + '\n'),
            "a.off:23: a face has the vertex 4 twice, wanted different corners; try: --repair");
}

// Notes of a triangle in `keyword` format whose rows end in these words. It has to be there.
std::vector<std::string> notes_of(const std::string& keyword, const std::vector<std::string>& ends)
{
  const Surface_file file = parse_off(keyword + "\n3 1 0\n0 0 0" + ends[0] + "\n1 0 0" + ends[1] +
                                          "\n0 1 0" + ends[2] + "\n3 0 1 2" + ends[3] + "\n",
                                      "a.off");
  EXPECT_EQ(file.points[1], (Point{1, 0, 0}));
  EXPECT_EQ(corners(file, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(file.vertices.properties.empty());
  return file.notes;
}

TEST(Read_off, leaves_out_attributes_that_not_all_vertices_have_or_that_are_none)
{
  const auto left_out = [](const std::string& what) {
    return std::vector<std::string>{"left out: " + what + ')'};
  };
  const std::string colors = "colours, which not all vertices have (";
  EXPECT_EQ(notes_of("COFF", {"", "", "", ""}), left_out(colors + "3, first: line 3"));
  EXPECT_EQ(notes_of("OFF", {" 1 2 3", "", " 1 2 3", ""}), left_out(colors + "1, first: line 4"));
  EXPECT_EQ(notes_of("OFF", {" 1 2 3", " 1 2 3 4", " 1 2 3 4", ""}),
            left_out(colors + "2, first: line 4"));
  const std::string none = "values of vertices that are not colours (";
  EXPECT_EQ(notes_of("OFF", {" 1", " 1 2", " 1 2 3 4 5", ""}), left_out(none + "3, first: line 3"));
  EXPECT_EQ(notes_of("OFF", {"", "", " 1 red 2", ""}), left_out(none + "1, first: line 5"));
  EXPECT_EQ(notes_of("STOFF", {" 1 0", " 1", " 1 1", ""}),
            left_out("texture coordinates, which not all vertices have (1, first: line 4"));
  EXPECT_EQ(notes_of("OFF", {"", "", "", " red"}),
            left_out("values of faces that are not colours (1, first: line 6"));
}

}  // namespace cgp_test::read_off_tests
