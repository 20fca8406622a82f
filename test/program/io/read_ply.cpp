// Tests examples/conformal/io/ply/read_ply.cpp examples/conformal/io/ply/Ply_header.cpp
// Tests examples/conformal/io/ply/Ply_body.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/ply/read_ply.h"

#include "program/io/io_support.h"
#include "tools/fuzz_readers_seeds.h"

#include <cmath>

namespace cgp_test::read_ply_tests {

using namespace conformal;
using namespace io_test;

const std::string ascii = "ply\nformat ascii 1.0\n";
const std::string vertex3 =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string face1 = "element face 1\nproperty list uchar int vertex_indices\n";
const std::string body3 = "end_header\n0 0 0\n1 0 0\n0 1 0\n";
const std::string triangle = ascii + vertex3 + face1 + body3 + "3 0 1 2\n";

std::string refusal(const std::string& text)
{
  return message_of([&] { parse_ply(text, "a.ply"); });
}

std::string replaced(std::string text, const std::string& old, const std::string& by)
{
  return text.replace(text.find(old), old.size(), by);
}

TEST(Read_ply, reads_points_and_faces_as_they_are)
{
  const Surface_file file = parse_ply(triangle, "a.ply");
  EXPECT_EQ(file.format, File_format::ply);
  EXPECT_EQ(file.points[1], (Point{1, 0, 0}));
  EXPECT_EQ(corners(file, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(file.vertices.properties.empty());
}

TEST(Read_ply, reads_both_byte_orders_alike)
{
  for (const bool big : {false, true}) {
    const Surface_file file = parse_ply(fuzz::binary_ply(big), "a.ply");
    ASSERT_EQ(file.points.size(), 4u);
    EXPECT_EQ(file.points[3], (Point{1, 1, 0.75}));
    EXPECT_EQ(corners(file, 1), (std::vector<int>{0, 3, 2}));
    EXPECT_EQ(types(file.vertices), "red:uchar green:uchar blue:uchar");
    EXPECT_EQ(values(file.vertices, "blue"), (std::vector<double>{100, 100, 100, 100}));
    EXPECT_EQ(types(file.faces), "texcoord:float[]");
    EXPECT_EQ(values(file.faces, "texcoord")[11], 0.625);
    ASSERT_EQ(file.other_elements.size(), 1u);
    EXPECT_EQ(values(file.other_elements[0], "vertex2"), (std::vector<double>{2}));
    EXPECT_EQ(file.comments, (std::vector<std::string>{"TextureFile a.png"}));
  }
}

TEST(Read_ply, keeps_unknown_properties_and_elements_with_their_types)
{
  const Surface_file file = parse_ply(fuzz::ply_seeds()[0], "a.ply");
  EXPECT_EQ(types(file.vertices), "quality:float texture_u:float texture_v:float");
  EXPECT_TRUE(std::isnan(values(file.vertices, "quality")[1]));
  EXPECT_EQ(types(file.faces), "texcoord:float[] label:int");
  EXPECT_EQ(find_property(file.faces, "texcoord")->count(1), 0u);
  EXPECT_EQ(values(file.faces, "label"), (std::vector<double>{7, -7}));
  EXPECT_EQ(file.object_info, (std::vector<std::string>{"made by hand"}));
}

TEST(Read_ply, rounds_the_digits_of_a_float_once)
{
  // 1 + 2^-24 + 2^-54: as a double it is the tie 1 + 2^-24, which would go on to 1
  const Surface_file file =
      parse_ply(replaced(triangle, "1 0 0", "1.00000005960464483 0 0"), "a.ply");
  EXPECT_EQ(file.points[1][0], 1.0 + std::ldexp(1.0, -23));
}

TEST(Read_ply, accepts_carriage_returns_and_a_byte_order_mark)
{
  std::string text = "\xef\xbb\xbf";
  for (const char c : triangle) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(parse_ply(text, "a.ply").points[2], (Point{0, 1, 0}));
}

/// The header with other line ends, and then the data
std::string with_ends(const std::string& text, const std::string& first, const std::string& middle,
                      const std::string& last)
{
  const std::size_t data = text.find("end_header\n") + 11;
  std::string header;
  for (std::size_t i = 0; i < data; ++i)
    header += text[i] != '\n' ? std::string(1, text[i])
              : i == 3        ? first
              : i + 1 == data ? last
                              : middle;
  return header + text.substr(data);
}

TEST(Read_ply, accepts_any_end_of_each_line_of_the_header)
{
  const std::string lf = "\n", cr = "\r", both = "\r\n";
  for (const std::string& text : {triangle, fuzz::binary_ply(false)})
    for (const auto& ends : {std::array{both, both, both},
                             {lf, lf, both},
                             {lf, both, both},
                             {lf, both, lf},
                             {both, lf, lf},
                             {cr, cr, cr},
                             {lf, lf, cr}}) {
      const Surface_file file = parse_ply(with_ends(text, ends[0], ends[1], ends[2]), "a.ply");
      EXPECT_EQ(file.points, parse_ply(text, "a.ply").points);
    }
}

TEST(Read_ply, takes_no_byte_of_the_data_for_a_line_end)
{
  std::string text = fuzz::binary_ply(false);
  text[text.find("end_header\n") + 11] = '\n';  // of the first coordinate
  const Surface_file file = parse_ply(with_ends(text, "\r", "\r", "\r"), "a.ply");
  EXPECT_EQ(file.points, parse_ply(text, "a.ply").points);
}

TEST(Read_ply, accepts_the_name_vertex_index_and_rows_over_several_lines)
{
  EXPECT_EQ(corners(parse_ply(replaced(triangle, "vertex_indices", "vertex_index"), "a.ply"), 0),
            (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(parse_ply(replaced(triangle, "1 0 0", "1\n0 0"), "a.ply").points[1], (Point{1, 0, 0}));
}

TEST(Read_ply, unrolls_triangle_strips)
{
  const Surface_file file = parse_ply(fuzz::ply_seeds()[3], "a.ply");
  ASSERT_EQ(file.polygons.size(), 3u);
  EXPECT_EQ(corners(file, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(corners(file, 1), (std::vector<int>{2, 1, 3}));
  EXPECT_EQ(corners(file, 2), (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(refusal(replaced(fuzz::ply_seeds()[3], "-1 0", "-2 0")),
            "a.ply:14: a strip has the vertex index -2, wanted -1 to 3");
}

TEST(Read_ply, leaves_out_undeclared_columns_with_a_note)
{
  const std::string text = replaced(ascii + vertex3 + face1 + body3, "face 1", "face 2");
  const Surface_file file = parse_ply(text + "3 0 1 2 3 1 1 1\n3 2 1 0 3 1 1 1\n", "a.ply");
  EXPECT_EQ(corners(file, 1), (std::vector<int>{2, 1, 0}));
  ASSERT_EQ(file.notes.size(), 1u);
  EXPECT_EQ(file.notes[0],
            "each face has 4 values that the header does not announce; they were left out");
  EXPECT_EQ(
      refusal(text + "3 0 1 2 9\n3 2 1 0\n"),
      "a.ply:13: a list vertex_indices of 9 values, wanted at most 5, which the bytes left hold");
}

TEST(Read_ply, refuses_bad_headers_with_their_line)
{
  EXPECT_EQ(refusal("plx\n"), "a.ply:1: the first line is not ply, wanted a PLY file");
  EXPECT_EQ(refusal("ply"), "a.ply:1: the file ends in the header, wanted end_header");
  EXPECT_EQ(refusal(ascii), "a.ply:3: the file ends in the header, wanted end_header");
  EXPECT_EQ(refusal("ply\nend_header\n"),
            "a.ply:2: no format line in the header, wanted format ascii 1.0 or the like");
  EXPECT_EQ(refusal(ascii + "format ascii 1.0\n"), "a.ply:3: a second format line, wanted one");
  EXPECT_EQ(refusal("ply\nformat text 1.0\n"),
            "a.ply:2: the format 'text', wanted ascii, binary_little_endian or binary_big_endian");
  EXPECT_EQ(refusal("ply\nformat ascii 2.0\n"), "a.ply:2: the version '2.0', wanted 1.0");
  EXPECT_EQ(
      refusal(ascii + "elements\n"),
      "a.ply:3: 'elements', wanted format, element, property, comment, obj_info or end_header");
  EXPECT_EQ(refusal(ascii + "element vertex -1\n"), "a.ply:3: -1 vertex elements, wanted a count");
  EXPECT_EQ(refusal(ascii + "element vertex x\n"),
            "a.ply:3: 'x' is not an integer, wanted the number of elements");
  EXPECT_EQ(refusal(ascii + vertex3 + vertex3), "a.ply:7: the element 'vertex' comes twice");
  EXPECT_EQ(refusal(ascii + "property float x\n"), "a.ply:3: a property before the first element");
  EXPECT_EQ(refusal(ascii + vertex3 + "property float x\n"),
            "a.ply:7: the property 'x' comes twice, wanted different names");
  EXPECT_EQ(refusal(ascii + vertex3 + "property half w\n"),
            "a.ply:7: the type 'half', wanted char, uchar, ..., float or double");
  EXPECT_EQ(refusal(ascii + vertex3 + "property list float int w\n"),
            "a.ply:7: the length of a list is not an integer, wanted uchar or the like");
  EXPECT_EQ(refusal(ascii + vertex3 + "property float w w\n"),
            "a.ply:7: 'w' ends the line, wanted nothing there");
  EXPECT_EQ(refusal(ascii + "element vertex\n"),
            "a.ply:3: the file ends, wanted the number of elements");
}

TEST(Read_ply, refuses_a_file_without_a_surface)
{
  EXPECT_EQ(refusal(ascii + "end_header\n"), "a.ply: no vertices, wanted a surface");
  EXPECT_EQ(refusal(ascii + vertex3 + body3), "a.ply: no faces, wanted a surface");
  EXPECT_EQ(refusal(replaced(triangle, "face 1", "face 0")), "a.ply: no faces, wanted a surface");
  EXPECT_EQ(refusal(replaced(triangle, "float z", "float w")),
            "a.ply: the vertices have no number z, wanted x, y and z");
  EXPECT_EQ(refusal(replaced(triangle, "vertex_indices", "corners")),
            "a.ply: the element face has no list vertex_indices, wanted one");
  EXPECT_EQ(refusal(replaced(triangle, "uchar int", "uchar float")),
            "a.ply: the property vertex_indices is not a list of integers");
}

TEST(Read_ply, refuses_counts_that_the_file_cannot_hold_at_once)
{
  EXPECT_EQ(refusal(replaced(triangle, "vertex 3", "vertex 353535235358")),
            "a.ply:3: 353535235358 vertices, wanted at most 2147483647");
  EXPECT_EQ(refusal(replaced(triangle, "vertex 3", "vertex 2000000000")),
            "a.ply:3: 2000000000 vertex elements, but the 27 bytes left hold at most 4");
  EXPECT_EQ(refusal(replaced(fuzz::binary_ply(false), "face 2", "face 2000000000")),
            "a.ply:11: 2000000000 face elements, but the 82 bytes left hold at most 41");
  EXPECT_EQ(
      refusal(replaced(triangle, "3 0 1 2", "200 0 1 2")),
      "a.ply:13: a list vertex_indices of 200 values, wanted at most 4, which the bytes left hold");
}

TEST(Read_ply, refuses_bad_values_with_their_line)
{
  EXPECT_EQ(refusal(replaced(triangle, "1 0 0", "1 nan 0")),
            "a.ply:11: the coordinate y is not finite");
  EXPECT_EQ(refusal(replaced(triangle, "1 0 0", "1 1e39 0")),
            "a.ply:11: the coordinate y is not finite");
  EXPECT_EQ(refusal(replaced(triangle, "1 0 0", "1 1,5 0")),
            "a.ply:11: '1,5' is not a number, wanted a number");
  EXPECT_EQ(refusal(replaced(triangle, "3 0 1 2", "2 0 1")),
            "a.ply:13: a face of 2 corners, wanted at least 3; try: --repair");
  EXPECT_EQ(refusal(replaced(triangle, "3 0 1 2", "3 0 1 3")),
            "a.ply:13: a face has the vertex index 3, wanted 0 to 2");
  EXPECT_EQ(refusal(replaced(triangle, "3 0 1 2", "3 0 1 1")),
            "a.ply:13: a face has the vertex 1 twice, wanted different corners; try: --repair");
  EXPECT_EQ(refusal(replaced(triangle, "3 0 1 2", "3 0 1 2147483648")),
            "a.ply:13: 2147483648 is out of the range of the type int");
  EXPECT_EQ(refusal(replaced(triangle, "3 0 1 2", "300 0 1 2")),
            "a.ply:13: 300 is out of the range of the type uchar");
  EXPECT_EQ(refusal(replaced(triangle, "3 0 1 2", "3 0 1 x")),
            "a.ply:13: 'x' is not an integer, wanted a value");
  EXPECT_EQ(refusal(replaced(triangle, "3 0 1 2\n", "3 0 1")),
            "a.ply:13: a list vertex_indices of 3 values, wanted at most 2, which the bytes left "
            "hold");
  EXPECT_EQ(refusal(replaced(replaced(triangle, "1 0 0", "1"), "0 1 0\n3 0 1 2\n", "0 1 0 1 2")),
            "a.ply:7: 1 face elements, but the 1 bytes left hold at most 0");
  EXPECT_EQ(refusal(triangle + "3 0 1 2\n"),
            "a.ply:14: '3' after the last element, wanted the end");
}

TEST(Read_ply, refuses_bad_binary_values_with_their_element)
{
  const auto with = [](std::size_t from_end, const std::string& bytes) {
    std::string text = fuzz::binary_ply(false);
    return text.replace(text.size() - from_end, bytes.size(), bytes);
  };
  // behind the vertices: two faces of 1 + 12 + 1 + 24 bytes and an edge of 6
  const std::size_t faces = 82;
  EXPECT_EQ(refusal(with(faces - 1, std::string("\4\0\0\0", 4))),
            "a.ply: face 0: a face has the vertex index 4, wanted 0 to 3");
  EXPECT_EQ(
      refusal(with(faces - 1, std::string("\1\0\0\0", 4))),
      "a.ply: face 0: a face has the vertex 1 twice, wanted different corners; try: --repair");
  EXPECT_EQ(refusal(with(faces + 4 * 19 - 2, std::string("\x80\x7f", 2))),
            "a.ply: vertex 0: the coordinate x is not finite");
  EXPECT_EQ(refusal(with(faces - 38, "\xff")),
            "a.ply: face 1: a list vertex_indices of 255 values, wanted at most "
            "10, which the bytes left hold");
  const std::string text = fuzz::binary_ply(false);
  EXPECT_EQ(refusal(text + "xyz"), "a.ply: 3 bytes after the last element, wanted the end");
  EXPECT_EQ(parse_ply(text + "\r\n", "a.ply").points.size(), 4u);
}

}  // namespace cgp_test::read_ply_tests
