// Tests examples/conformal/io/ply/write_ply.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/ply/write_ply.h"

#include "conformal/io/obj/read_obj.h"
#include "conformal/io/off/read_off.h"
#include "conformal/io/ply/read_ply.h"
#include "program/io/io_support.h"
#include "tools/fuzz_readers_seeds.h"

#include <cmath>
#include <cstring>

namespace cgp_test::write_ply_tests {

using namespace conformal;
using namespace io_test;

constexpr std::array encodings = {Ply_encoding::ascii, Ply_encoding::little_endian,
                                  Ply_encoding::big_endian};

std::string encode(const Surface_file& file, Ply_encoding encoding)
{
  std::vector<std::string> notes;
  return encode_ply(file, {encoding}, notes);
}

bool has_same_bits(const Element& a, const Element& b)
{
  bool same = a.name == b.name && a.size == b.size && types(a) == types(b);
  for (std::size_t i = 0; same && i < a.properties.size(); ++i) {
    const Property &p = a.properties[i], &q = b.properties[i];
    same = p.values() == q.values() && p.count_type() == q.count_type() &&
           (p.values() == 0 ||
            std::memcmp(p.bytes(0), q.bytes(0), p.values() * size_of(p.type())) == 0);
    for (std::size_t row = 0; same && row < p.rows(); ++row) same = p.count(row) == q.count(row);
  }
  return same;
}

TEST(Write_ply, writes_text_that_one_expects)
{
  Surface_file file = parse_off("OFF\n3 1 0\n0 0 0\n1 0 0.1\n0 1e-9 0\n3 0 1 2\n", "a.off");
  set_property(file.vertices, "quality", std::vector<float>{1.0f, 0.1f, NAN});
  EXPECT_EQ(encode(file, Ply_encoding::ascii),
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
            "property double z\nproperty float quality\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n"
            "0 0 0 1\n1 0 0.1 0.1\n0 1e-09 0 nan\n3 0 1 2\n");
}

TEST(Write_ply, keeps_everything_of_a_ply_file_bit_for_bit)
{
  for (const std::string& seed : {fuzz::ply_seeds()[0], fuzz::ply_seeds()[1]})
    for (const Ply_encoding encoding : encodings) {
      const Surface_file file = parse_ply(seed, "a.ply");
      const Surface_file again = parse_ply(encode(file, encoding), "b.ply");
      EXPECT_EQ(again.points, file.points);
      EXPECT_EQ(again.polygons.first, file.polygons.first);
      EXPECT_EQ(again.polygons.corners, file.polygons.corners);
      EXPECT_TRUE(has_same_bits(again.vertices, file.vertices));
      EXPECT_TRUE(has_same_bits(again.faces, file.faces));
      ASSERT_EQ(again.other_elements.size(), file.other_elements.size());
      for (std::size_t i = 0; i < file.other_elements.size(); ++i)
        EXPECT_TRUE(has_same_bits(again.other_elements[i], file.other_elements[i]));
      EXPECT_EQ(again.comments, file.comments);
      EXPECT_EQ(again.object_info, file.object_info);
      EXPECT_EQ(encode(again, encoding), encode(file, encoding));
    }
}

TEST(Write_ply, keeps_the_payload_of_a_nan_in_binary)
{
  Surface_file file = parse_ply(fuzz::ply_seeds()[0], "a.ply");
  const unsigned char payload[4] = {0x45, 0x23, 0xc1, 0xff};
  Property property("strange", Value_type::float32);
  for (std::size_t v = 0; v < 4; ++v) property.append_bytes(payload, false);
  set_property(file.vertices, std::move(property));
  for (const Ply_encoding encoding : {Ply_encoding::little_endian, Ply_encoding::big_endian}) {
    const Surface_file again = parse_ply(encode(file, encoding), "b.ply");
    EXPECT_EQ(std::memcmp(find_property(again.vertices, "strange")->bytes(2), payload, 4), 0);
  }
}

TEST(Write_ply, keeps_every_double_of_a_point)
{
  Surface_file file = parse_off("OFF\n3 1 0\n0.1 1e300 5e-324\n1 0 0\n-0 1 0\n3 0 1 2\n", "a.off");
  for (const Ply_encoding encoding : encodings) {
    const Surface_file again = parse_ply(encode(file, encoding), "b.ply");
    EXPECT_EQ(again.points, file.points);
    EXPECT_TRUE(std::signbit(again.points[2][0]));
  }
}

TEST(Write_ply, writes_coordinates_in_single_precision_on_request)
{
  const Surface_file file =
      parse_off("OFF\n3 1 0\n0.1 0 0\n1 0 0\n0 16777217 0\n3 0 1 2\n", "a.off");
  std::vector<std::string> notes;
  for (const Ply_encoding encoding : encodings) {
    const std::string bytes = encode_ply(file, {encoding, Value_type::float32}, notes);
    EXPECT_NE(bytes.find("property float x"), std::string::npos);
    const Surface_file again = parse_ply(bytes, "b.ply");
    EXPECT_EQ(again.points[0][0], static_cast<double>(0.1f));
    EXPECT_EQ(again.points[2][1], 16777216);
    EXPECT_EQ(encode_ply(again, {encoding, Value_type::float32}, notes), bytes);
  }
}

TEST(Write_ply, gives_attributes_of_text_formats_the_types_that_viewers_know)
{
  const Surface_file file = parse_off(
      "STCNOFF\n3 1 0\n0 0 0 0 0 1 0 0.5 1 0 0\n1 0 0 0 0 1 0 0 0 1 0\n0 1 0 0 0 1 1 1 1 0 1\n"
      "3 0 1 2\n",
      "a.off");
  const Surface_file again = parse_ply(encode(file, Ply_encoding::ascii), "b.ply");
  EXPECT_EQ(types(again.vertices),
            "nx:float ny:float nz:float red:uchar green:uchar blue:uchar texture_u:float "
            "texture_v:float");
  EXPECT_EQ(values(again.vertices, "green"), (std::vector<double>{128, 0, 255}));
}

TEST(Write_ply, keeps_colours_that_are_no_bytes)
{
  const Surface_file file =
      parse_obj("v 0 0 0 nan 0 0\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n", "a.obj");
  const Surface_file again = parse_ply(encode(file, Ply_encoding::ascii), "b.ply");
  EXPECT_EQ(types(again.vertices), "red:double green:double blue:double");
  EXPECT_TRUE(std::isnan(values(again.vertices, "red")[0]));
}

const std::string square =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 5\n";

TEST(Write_ply, writes_texture_coordinates_without_seams_to_the_vertices)
{
  const Surface_file file = parse_obj(square + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n", "a.obj");
  const Surface_file again = parse_ply(encode(file, Ply_encoding::little_endian), "b.ply");
  EXPECT_EQ(types(again.vertices), "texture_u:float texture_v:float");
  EXPECT_EQ(values(again.vertices, "texture_u"), (std::vector<double>{0, 1, 1, 0}));
}

TEST(Write_ply, writes_texture_coordinates_with_seams_to_the_faces)
{
  const Surface_file file = parse_obj(square + "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\nf 1 2 4\n", "a.obj");
  const Surface_file again = parse_ply(encode(file, Ply_encoding::ascii), "b.ply");
  EXPECT_EQ(types(again.faces), "texcoord:float[]");
  EXPECT_EQ(find_property(again.faces, "texcoord")->count_type(), Value_type::uint8);
  EXPECT_EQ(values(again.faces, "texcoord"),
            (std::vector<double>{0, 0, 1, 0, 1, 1, 5, 5, 1, 1, 0, 1}));
  EXPECT_EQ(find_property(again.faces, "texcoord")->count(2), 0u);
}

TEST(Write_ply, writes_normals_of_vertices_and_notes_what_it_leaves_out)
{
  std::vector<std::string> notes;
  const std::string points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 1 0 0\n";
  encode_ply(parse_obj(points + "f 1//1 2//1 3//2\nf 1//1 3//2 4//1\n", "a.obj"),
             {Ply_encoding::ascii}, notes);
  EXPECT_TRUE(notes.empty());
  encode_ply(parse_obj(points + "g a\nf 1//1 2//1 3//2\nf 1//2 3//2 4//1\n", "a.obj"),
             {Ply_encoding::ascii}, notes);
  EXPECT_EQ(notes, (std::vector<std::string>{
                       "normals that differ at the corners of a vertex are not written to PLY",
                       "groups and materials are not written to PLY"}));
}

TEST(Write_ply, counts_the_corners_of_large_faces)
{
  std::string text = "OFF\n300 1 0\n", face = "300";
  for (int v = 0; v < 300; ++v) {
    text += std::to_string(v) + " 0 0\n";
    face += ' ' + std::to_string(v);
  }
  const Surface_file file = parse_off(text + face + '\n', "a.off");
  for (const Ply_encoding encoding : encodings)
    EXPECT_EQ(parse_ply(encode(file, encoding), "b.ply").polygons.corners, file.polygons.corners);
}

TEST(Write_ply, keeps_comments_on_one_line)
{
  Surface_file file = parse_ply(fuzz::ply_seeds()[0], "a.ply");
  file.comments = {"two\nlines", " blanks around "};
  EXPECT_EQ(parse_ply(encode(file, Ply_encoding::ascii), "b.ply").comments,
            (std::vector<std::string>{"two lines", " blanks around "}));
}

}  // namespace cgp_test::write_ply_tests
