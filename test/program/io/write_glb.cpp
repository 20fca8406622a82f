// Tests examples/conformal/io/glb/write_glb.cpp examples/conformal/io/glb/Glb_mesh.cpp
// Tests examples/conformal/io/glb/checkerboard.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/glb/write_glb.h"

#include "conformal/io/file/little_endian.h"
#include "conformal/io/glb/Glb_mesh.h"
#include "conformal/io/glb/checkerboard.h"
#include "conformal/io/obj/read_obj.h"
#include "conformal/io/off/read_off.h"
#include "program/io/io_support.h"

#include <cmath>

namespace cgp_test::write_glb_tests {

using namespace conformal;
using namespace io_test;

const std::string square =
    "v 10 0 0\nv 12 0 0\nv 12 2 0\nv 10 2 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 0.25\n";

std::string encode(const Surface_file& file)
{
  std::vector<std::string> notes;
  return encode_glb(file, "a.glb", notes);
}

std::string json_of(const std::string& glb)
{
  return glb.substr(20, little_endian<std::uint32_t>(glb.data() + 12));
}

bool contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(Glb_mesh, is_centred_on_the_bounding_box)
{
  const Glb_mesh mesh = glb_mesh(parse_obj(square + "f 1 2 3 4\n", "a.obj"));
  EXPECT_EQ(mesh.middle, (Point{11, 1, 0}));
  EXPECT_EQ(mesh.positions[0], (std::array<float, 3>{-1, -1, 0}));
}

TEST(Glb_mesh, splits_vertices_on_seams_behind_all_others)
{
  const Glb_mesh mesh = glb_mesh(parse_obj(square + "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n", "a.obj"));
  ASSERT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.positions[4], mesh.positions[0]);
  EXPECT_EQ(mesh.texture[1], (std::array<float, 2>{1, 1}));
  EXPECT_EQ(mesh.texture[4], (std::array<float, 2>{5, 0.75f}));
  EXPECT_EQ(mesh.triangles[0], (std::array<std::uint32_t, 3>{0, 1, 2}));
  EXPECT_EQ(mesh.triangles[1], (std::array<std::uint32_t, 3>{4, 2, 3}));
}

TEST(Glb_mesh, cuts_polygons_into_fans)
{
  const Glb_mesh mesh = glb_mesh(parse_obj(square + "f 2 3 4 1\n", "a.obj"));
  ASSERT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.triangles[1], (std::array<std::uint32_t, 3>{1, 3, 0}));
}

TEST(Glb_mesh, averages_normals_of_length_one_from_the_faces)
{
  const Glb_mesh mesh = glb_mesh(
      parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 9 9 9\nf 1 2 3\nf 1 4 2\n", "a.obj"));
  const float half = static_cast<float>(std::sqrt(0.5));
  EXPECT_EQ(mesh.normals[2], (std::array<float, 3>{0, 0, 1}));
  EXPECT_EQ(mesh.normals[3], (std::array<float, 3>{0, 1, 0}));
  EXPECT_EQ(mesh.normals[0], (std::array<float, 3>{0, half, half}));
  EXPECT_EQ(mesh.normals[4], (std::array<float, 3>{0, 0, 1})) << "no face is there";
}

TEST(Glb_mesh, takes_the_normals_of_the_file)
{
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const Glb_mesh mesh = glb_mesh(parse_obj(points + "vn 2 0 0\nf 1//1 2//1 3//1\n", "a.obj"));
  EXPECT_EQ(mesh.normals[0], (std::array<float, 3>{1, 0, 0}));
  const Surface_file file =
      parse_off("NOFF\n3 1 0\n0 0 0 0 2 0\n1 0 0 0 nan 0\n0 1 0 0 0 0\n3 0 1 2\n", "a.off");
  EXPECT_EQ(glb_mesh(file).normals[0], (std::array<float, 3>{0, 1, 0}));
  EXPECT_EQ(glb_mesh(file).normals[1], (std::array<float, 3>{0, 0, 1}));
}

TEST(Glb_mesh, has_colours_in_bytes)
{
  using Color = std::array<unsigned char, 4>;
  const Surface_file real =
      parse_obj("v 0 0 0 0.5 nan 7\nv 1 0 0 0 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n", "a.obj");
  EXPECT_EQ(glb_mesh(real).colors[0], (Color{128, 0, 255, 255}));
  const Surface_file bytes =
      parse_off("COFF\n3 1 0\n0 0 0 1 2 3 4\n1 0 0 0 0 0 0\n0 1 0 0 0 0 0\n3 0 1 2\n", "a.off");
  EXPECT_EQ(glb_mesh(bytes).colors[0], (Color{1, 2, 3, 4}));
}

TEST(Write_glb, has_a_header_and_two_chunks_of_the_right_lengths)
{
  const std::string glb = encode(parse_obj(square + "f 1/1 2/2 3/3\n", "a.obj"));
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(little_endian<std::uint32_t>(glb.data() + 4), 2u);
  EXPECT_EQ(little_endian<std::uint32_t>(glb.data() + 8), glb.size());
  const std::size_t json = little_endian<std::uint32_t>(glb.data() + 12);
  EXPECT_EQ(glb.substr(16, 4), "JSON");
  EXPECT_EQ(json % 4, 0u);
  EXPECT_EQ(little_endian<std::uint32_t>(glb.data() + 20 + json) + 28 + json, glb.size());
  EXPECT_EQ(glb.substr(24 + json, 4), std::string("BIN\0", 4));
}

TEST(Write_glb, describes_its_arrays)
{
  const std::string glb = encode(parse_obj(square + "f 1 2 3 4\n", "a.obj"));
  const std::string json = json_of(glb);
  EXPECT_TRUE(contains(json, "\"attributes\":{\"POSITION\":0,\"NORMAL\":1},\"indices\":2"));
  EXPECT_TRUE(contains(json, "\"translation\":[11,1,0]"));
  EXPECT_TRUE(contains(json,
                       "{\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":4,"
                       "\"min\":[-1,-1,0],\"max\":[1,1,0]}"));
  EXPECT_TRUE(
      contains(json, "{\"bufferView\":2,\"componentType\":5125,\"type\":\"SCALAR\",\"count\":6}"));
  EXPECT_TRUE(
      contains(json, "{\"buffer\":0,\"byteOffset\":96,\"byteLength\":24,\"target\":34963}"));
  const char* binary = glb.data() + 28 + json.size();
  EXPECT_EQ(little_endian<float>(binary), -1.0f);
  EXPECT_EQ(little_endian<std::uint32_t>(binary + 96 + 20), 3u);
}

TEST(Write_glb, shows_a_checkerboard_where_there_are_no_colours)
{
  const std::string textured = json_of(encode(parse_obj(square + "f 1/1 2/2 3/3\n", "a.obj")));
  EXPECT_TRUE(contains(textured, "\"TEXCOORD_0\":2"));
  EXPECT_TRUE(contains(textured, "\"mimeType\":\"image/png\",\"bufferView\":4"));
  const std::string colored =
      json_of(encode(parse_obj("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n", "a.obj")));
  EXPECT_TRUE(contains(colored, "\"COLOR_0\":2"));
  EXPECT_TRUE(contains(colored, "\"type\":\"VEC4\",\"count\":3,\"normalized\":true"));
  EXPECT_FALSE(contains(colored, "image/png"));
}

TEST(Write_glb, refuses_coordinates_that_are_no_floats)
{
  const Surface_file file = parse_off("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1e300 0\n3 0 1 2\n", "a.off");
  EXPECT_EQ(message_of<Write_error>([&] { encode(file); }),
            "a.glb: vertex 0 does not fit into GLB, whose coordinates are floats");
}

TEST(Write_glb, notes_what_the_format_has_no_place_for)
{
  Surface_file file = parse_obj(square + "g a\nusemtl red\nf 1 2 3 4\n", "a.obj");
  set_property(file.vertices, "quality", std::vector<float>{0, 0, 0, NAN});
  std::vector<std::string> notes;
  encode_glb(file, "a.glb", notes);
  EXPECT_EQ(notes, (std::vector<std::string>{"the vertex property quality is not written to GLB",
                                             "groups and materials are not written to GLB",
                                             "polygons are written to GLB as triangles"}));
}

TEST(Checkerboard, is_a_png_of_stored_rows)
{
  const std::string png = checkerboard_png(2, 1);
  // signature; IHDR 2 x 2; IDAT: zlib header, one stored block of two rows of 7 bytes
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(8, 25),
            std::string("\0\0\0\x0dIHDR\0\0\0\2\0\0\0\2\x08\2\0\0\0\xfd\xd4\x9a\x73", 25));
  EXPECT_EQ(png.substr(41, 7), std::string("\x78\x01\x01\x0e\0\xf1\xff", 7));
  EXPECT_EQ(png.substr(48, 14),
            std::string("\0\xff\xff\xff\x5a\x78\xa0\0\x5a\x78\xa0\xff\xff\xff", 14));
  EXPECT_EQ(png.substr(png.size() - 12), std::string("\0\0\0\0IEND\xae\x42\x60\x82", 12));
}

TEST(Checkerboard, has_several_blocks_and_a_checksum_if_it_is_large)
{
  const std::string png = checkerboard_png(16, 16);
  // 256 rows of 769 bytes are three blocks of 65535 bytes and one of 259; the checksum is zlib's
  EXPECT_EQ(png.substr(43 + 3 * (5 + 65535), 5), std::string("\x01\x03\x01\xfc\xfe", 5));
  EXPECT_EQ(png.substr(png.size() - 20, 4), std::string("\x4c\xac\xa1\x3a", 4));
}

}  // namespace cgp_test::write_glb_tests
