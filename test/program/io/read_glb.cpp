// Tests examples/conformal/io/glb/read_glb.cpp examples/conformal/io/glb/Glb_content.cpp
// Tests examples/conformal/io/data/Vertex_merger.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/glb/read_glb.h"

#include "program/io/io_support.h"

#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/file/little_endian.h"
#include "conformal/io/glb/write_glb.h"
#include "conformal/io/obj/read_obj.h"

#include <cmath>
#include <string>

namespace cgp_test::read_glb_tests {

using namespace io_test;
using namespace conformal;

std::string glb(std::string json, const std::string& binary)
{
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::string bytes = "glTF";
  for (const std::size_t n : {std::size_t{2}, 28 + json.size() + binary.size(), json.size()})
    append_little_endian(bytes, static_cast<std::uint32_t>(n));
  bytes += "JSON" + json;
  append_little_endian(bytes, static_cast<std::uint32_t>(binary.size()));
  return bytes + std::string("BIN\0", 4) + binary;
}

/// a triangle whose node is moved by (5, 0, 0) and twice as large
const std::string triangle =
    R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"translation":[5,0,0],"scale":[2,2,2]}],
"meshes":[{"name":"part","primitives":[{"attributes":{"POSITION":0},"material":0}]}],
"materials":[{"name":"steel"}],"buffers":[{"byteLength":36}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}]})";

std::string three_points()
{
  std::string bytes;
  for (const float x : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f})
    append_little_endian(bytes, x);
  return bytes;
}

TEST(Read_glb, reads_what_is_written)
{
  const Surface_file file = parse_obj(
      "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 0 1 0\nv 0 1 0 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n"
      "vt 0.5 1\nvt 0.25 0.25\nf 1/1 2/2 3/3\nf 1/5 3/3 4/4\n",
      "a.obj");
  std::vector<std::string> notes;
  const Surface_file again = parse_glb(encode_glb(file, "a.glb", notes), "a.glb");
  EXPECT_EQ(again.points, file.points);
  EXPECT_EQ(again.polygons.corners, file.polygons.corners);
  const Corner_values texture = texture_coordinates(again);
  ASSERT_EQ(texture.index.size(), 6u);
  for (std::size_t c = 0; c < 6; ++c)
    EXPECT_EQ(texture.values[static_cast<std::size_t>(texture.index[c])],
              file.texture.values[static_cast<std::size_t>(file.texture.index[c])]);
  EXPECT_EQ(values(again.vertices, "green"), (std::vector<double>{0, 0, 255, 0}));
}

TEST(Read_glb, puts_meshes_in_their_places_and_keeps_names)
{
  const Surface_file file = parse_glb(glb(triangle, three_points()), "a.glb");
  EXPECT_EQ(file.points[1], (Point{7, 0, 0}));
  EXPECT_EQ(file.points[2], (Point{5, 2, 0}));
  ASSERT_EQ(file.group_lines.size(), 2u);
  EXPECT_EQ(file.group_lines[0].text, "o part");
  EXPECT_EQ(file.group_lines[1].text, "usemtl steel");
}

TEST(Read_glb, notes_that_materials_lose_their_colours)
{
  std::string painted = triangle;
  const std::string steel = R"({"name":"steel"})";
  painted.replace(painted.find(steel), steel.size(),
                  R"({"name":"steel","pbrMetallicRoughness":{"metallicFactor":1}})");
  EXPECT_TRUE(parse_glb(glb(triangle, three_points()), "a.glb").notes.empty());
  EXPECT_EQ(parse_glb(glb(painted, three_points()), "a.glb").notes,
            (std::vector<std::string>{
                "of materials the names are kept, colours and pictures are left out"}));
  std::vector<std::string> notes;
  const Surface_file ours = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  EXPECT_TRUE(parse_glb(encode_glb(ours, "b.glb", notes), "b.glb").notes.empty());
}

std::string message(const std::string& bytes)
{
  return message_of([&] { parse_glb(bytes, "a.glb"); });
}

TEST(Read_glb, refuses_what_is_damaged_with_a_reason)
{
  const auto with = [](const std::string& what, const std::string& other) {
    std::string text = triangle;
    return glb(text.replace(text.find(what), what.size(), other), three_points());
  };
  EXPECT_EQ(message("glTF"), "a.glb: is not a GLB file of version 2");
  EXPECT_NE(message(glb(triangle, "")).find("not in its binary chunk"), std::string::npos);
  EXPECT_NE(message(glb("{", "")).find("is not a GLB file"), std::string::npos);
  EXPECT_NE(message(with("\"count\":3", "\"count\":4")).find("does not fit"), std::string::npos);
  EXPECT_NE(message(with("5126", "5000")).find("unknown type"), std::string::npos);
  EXPECT_NE(message(with("\"mesh\":0,", "\"children\":[0],")).find("below itself"),
            std::string::npos);
  EXPECT_NE(message(with("\"asset\"", "\"extensionsRequired\":[\"X\"],\"asset\""))
                .find("needs the extension X"),
            std::string::npos);
  EXPECT_NE(message(with("\"POSITION\":0", "\"POSITION\":7")).find("is not a GLB file"),
            std::string::npos);
  const std::string whole = glb(triangle, three_points());
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(message(whole.substr(0, size)), "no error") << size;
}

/// 64 nodes, of which each is twice below the one before: 2^63 ways to the last one
TEST(Read_glb, refuses_nodes_below_two_others_at_once)
{
  std::string nodes = "\"nodes\":[";
  for (int k = 1; k < 64; ++k) {
    const std::string child = std::to_string(k);
    nodes += "{\"children\":[" + child + ',' + child + "]},";
  }
  std::string text = triangle;
  const std::string before = "\"nodes\":[{\"mesh\"";
  text.replace(text.find(before), before.size(), nodes + "{\"mesh\"");
  EXPECT_NE(message(glb(text, three_points())).find("below two others"), std::string::npos);
}

TEST(Read_glb, refuses_indices_that_are_negative_or_no_numbers)
{
  const auto with_index = [](float index) {
    std::string bytes = three_points(), text = triangle;
    for (const float i : {0.f, 1.f, index}) append_little_endian(bytes, i);
    const auto put = [&text](const std::string& at, const std::string& what) {
      text.insert(text.find(at), what);
    };
    put("\"material\":0}", "\"indices\":1,");
    put("}],\n\"accessors", "},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":12");
    text.replace(text.rfind("]}"), 2,
                 ",{\"bufferView\":1,\"componentType\":5126,\"type\":\"SCALAR\",\"count\":3}]}");
    return glb(text, bytes);
  };
  EXPECT_EQ(parse_glb(with_index(2), "a.glb").polygons.size(), 1u);
  for (const float index : {-1.f, 3.f, -std::nanf("")})
    EXPECT_NE(message(with_index(index)).find("has the vertex index"), std::string::npos) << index;
}

}  // namespace cgp_test::read_glb_tests
