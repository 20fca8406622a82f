// Tests examples/conformal/io/glb/read_glb.cpp examples/conformal/io/glb/Glb_content.cpp
// Tests examples/conformal/io/glb/attribute_names.cpp examples/conformal/io/file/base64.cpp
// Tests examples/conformal/io/data/Vertex_merger.h
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/glb/read_glb.h"

#include "program/io/io_support.h"

#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/file/base64.h"
#include "conformal/io/file/little_endian.h"
#include "conformal/io/glb/attribute_names.h"
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

/// the triangle with another text in the place of a part of its description
std::string with(const std::string& what, const std::string& other,
                 const std::string& binary = three_points())
{
  std::string text = triangle;
  return glb(text.replace(text.find(what), what.size(), other), binary);
}

std::string message(const std::string& bytes)
{
  return message_of([&] { parse_glb(bytes, "a.glb"); });
}

TEST(Read_glb, turns_faces_that_a_node_reflects)
{
  for (const char* scale : {"[2,2,-2]", "[-2,2,2]", "[-2,-2,-2]"})
    EXPECT_EQ(corners(parse_glb(with("[2,2,2]", scale), "a.glb"), 0), (std::vector<int>{0, 2, 1}));
  EXPECT_EQ(corners(parse_glb(with("[2,2,2]", "[-2,-2,2]"), "a.glb"), 0),
            (std::vector<int>{0, 1, 2}));
}

TEST(Read_glb, reads_chains_of_nodes_of_any_length)
{
  std::string nodes = "\"nodes\":[";
  for (int k = 1; k <= 100000; ++k) nodes += "{\"children\":[" + std::to_string(k) + "]},";
  const Surface_file file = parse_glb(with("\"nodes\":[{\"mesh\"", nodes + "{\"mesh\""), "a.glb");
  EXPECT_EQ(file.points[1], (Point{7, 0, 0}));
}

/// n points of the curve (i, i^2, i^3), of which no three are in line
std::string curve(int n)
{
  std::string bytes;
  for (int i = 0; i < n; ++i)
    for (int power : {i, i * i, i * i * i}) append_little_endian(bytes, static_cast<float>(power));
  return bytes;
}

TEST(Read_glb, unrolls_strips_and_fans)
{
  const auto faces = [](const std::string& mode) {
    std::string text = triangle;
    for (const auto& [what, other] :
         {std::pair("\"material\":0", "\"mode\":" + mode), std::pair("36}]", std::string("60}]")),
          std::pair("36}]", std::string("60}]")),
          std::pair("\"count\":3", std::string("\"count\":5"))})
      text.replace(text.find(what), std::string(what).size(), other);
    return parse_glb(glb(text, curve(5)), "a.glb").polygons.corners;
  };
  EXPECT_EQ(faces("5"), (std::vector<int>{0, 1, 2, 1, 3, 2, 2, 3, 4}));
  EXPECT_EQ(faces("6"), (std::vector<int>{0, 1, 2, 0, 2, 3, 0, 3, 4}));
  EXPECT_EQ(faces("4"), (std::vector<int>{0, 1, 2}));
}

TEST(Read_glb, reads_buffers_in_the_description)
{
  std::string json = triangle;
  const std::string size = "[{\"byteLength\":36}]", data = "data:application/octet-stream;base64,";
  json.replace(json.find(size), size.size(),
               "[{\"byteLength\":36,\"uri\":\"" + data + base64(three_points()) + "\"}]");
  const std::string all = glb(json, "");
  const Surface_file file = parse_glb(all.substr(0, all.size() - 8), "a.glb");  // one chunk
  EXPECT_EQ(file.points[1], (Point{7, 0, 0}));
  EXPECT_EQ(message(with(size, "[{\"uri\":\"a.bin\"}]")),
            "a.glb: buffers[0] is at 'a.bin', wanted a GLB file that holds all its data");
}

TEST(Read_glb, reads_the_base64_that_is_written)
{
  for (std::size_t size = 0; size < 300; ++size) {
    std::string bytes;
    for (std::size_t i = 0; i < size; ++i) bytes += static_cast<char>(7 * i + size);
    EXPECT_EQ(from_base64(base64(bytes)), bytes);
  }
  EXPECT_EQ(from_base64("Zm9v!"), "");
}

TEST(Read_glb, reads_sparse_tables_without_and_with_others_below_them)
{
  std::string bytes("\2\0\0\0", 4);
  for (const float x : {0.f, 8.f, 0.f}) append_little_endian(bytes, x);
  const std::string sparse =
      R"("sparse":{"count":1,"indices":{"bufferView":1,"componentType":5125},"values":{"bufferView":1,"byteOffset":4}},)";
  const std::string view = "}],\n\"accessors",
                    views = "},{\"buffer\":0,\"byteOffset\":36,\"byteLength\":16";
  const auto with_table = [&](const std::string& table) {
    std::string text = triangle;
    const std::string whole = "{\"bufferView\":0,\"componentType";
    text.replace(text.find(whole), whole.size(), table + "\"componentType");
    return glb(text.insert(text.find(view), views), three_points() + bytes);
  };
  const Surface_file file = parse_glb(with_table("{\"bufferView\":0," + sparse), "a.glb");
  EXPECT_EQ(file.points[1], (Point{7, 0, 0}));
  EXPECT_EQ(file.points[2], (Point{5, 16, 0}));
  EXPECT_EQ(
      message(with_table('{' + sparse)),  // two points at the origin
      "a.glb: face 0: a face has the vertex 0 twice, wanted different corners; try: --repair");
}

TEST(Read_glb, reads_quantized_numbers_and_leaves_out_extensions_of_looks)
{
  const auto requires = [](const std::string& name) {
    return with("\"asset\"", "\"extensionsUsed\":[\"" + name + "\"],\"extensionsRequired\":[\"" +
                                 name + "\"],\"asset\"");
  };
  EXPECT_TRUE(parse_glb(requires("KHR_mesh_quantization"), "a.glb").notes.empty());
  EXPECT_EQ(parse_glb(requires("KHR_materials_unlit"), "a.glb").notes,
            (std::vector<std::string>{"left out: the extension KHR_materials_unlit"}));
  EXPECT_EQ(message(requires("KHR_draco_mesh_compression")),
            "a.glb: needs the extension KHR_draco_mesh_compression, wanted GLB without extensions");
}

TEST(Read_glb, notes_everything_that_it_leaves_out)
{
  std::string text = triangle;
  const auto put = [&text](const std::string& before, const std::string& what) {
    text.insert(text.find(before), what);
  };
  put("\"mesh\":0", "\"name\":\"node\",\"skin\":0,\"camera\":0,");
  put("\"POSITION\"", "\"TEXCOORD_1\":0,\"JOINTS_0\":0,\"_VECTOR\":0,");
  put("\"material\":0", "\"targets\":[{}],");
  put("\"name\":\"steel\"", "\"alphaMode\":\"BLEND\",");
  put("\"asset\"", "\"animations\":[{}],\"skins\":[{}],");
  put("]}],\n\"materials", ",{\"mode\":0,\"attributes\":{}}");
  const Surface_file file = parse_glb(glb(text, three_points()), "a.glb");
  EXPECT_EQ(file.group_lines[0].text, "g node");
  std::vector<std::string> left_out;
  for (const std::string& note : file.notes)
    left_out.push_back(note.substr(10, note.find(" (") - 10));
  EXPECT_EQ(left_out, (std::vector<std::string>{
                          "camera", "skin", "targets", "colours and pictures of materials",
                          "JOINTS_0", "TEXCOORD_1", "_VECTOR", "points and lines", "animations"}));
}

TEST(Read_glb, notes_scenes_and_meshes_that_are_not_shown)
{
  std::string text = triangle;
  text.replace(text.find("{\"nodes\":[0]}"), 13, "{\"nodes\":[0]},{\"nodes\":[]}");
  text.insert(text.find("{\"name\":\"part\""), "{\"primitives\":[]},");
  text.replace(text.find("\"mesh\":0"), 8, "\"mesh\":1");
  EXPECT_EQ(
      parse_glb(glb(text, three_points()), "a.glb").notes,
      (std::vector<std::string>{"left out: further scenes (1, first: scenes[1])",
                                "left out: meshes outside of the scene (1, first: meshes[0])"}));
}

TEST(Read_glb, notes_no_looks_of_own_files)
{
  std::vector<std::string> notes;
  const Surface_file ours = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  EXPECT_TRUE(parse_glb(encode_glb(ours, "b.glb", notes), "b.glb").notes.empty());
}

TEST(Read_glb, keeps_values_of_vertices_in_order)
{
  Surface_file file = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
  const std::vector<std::string> names = {"rho", "quality", "Mixed_case", "a"};
  for (const std::string& name : names)
    set_property(file.vertices, name, std::vector<float>{0.1f, -2.0f, static_cast<float>(name[0])});
  std::vector<std::string> notes;
  const std::string bytes = encode_glb(file, "a.glb", notes);
  EXPECT_TRUE(notes.empty());
  EXPECT_NE(bytes.find("\"_RHO\":2,\"_QUALITY\":3,\"_Mixed_case\":4"), std::string::npos);
  const Surface_file again = parse_glb(bytes, "a.glb");
  EXPECT_EQ(types(again.vertices), types(file.vertices));
  for (const std::string& name : names)
    EXPECT_EQ(values(again.vertices, name), values(file.vertices, name));
}

TEST(Attribute_names, lead_back_to_the_property_or_are_none)
{
  for (const char* name : {"rho", "Rho", "r2", "a.b", "_"})
    EXPECT_EQ(property_of(attribute_of(name).value_or("")), std::optional<std::string>(name));
  for (const char* name : {"", "x", "RHO", "say\"so", "\xc3\xa4"}) EXPECT_FALSE(attribute_of(name));
  for (const char* name : {"POSITION", "_", "_X", "_two words"}) EXPECT_FALSE(property_of(name));
}

TEST(Read_glb, keeps_alpha_where_it_is_not_1)
{
  for (const char* alpha : {"255", "128"}) {
    std::vector<std::string> notes;
    Surface_file file = parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj");
    set_properties(file.vertices, {"red", "green", "blue", "alpha"}, Value_type::uint8,
                   {1, 2, 3, std::stod(alpha), 1, 2, 3, 255, 1, 2, 3, 255});
    const Surface_file again = parse_glb(encode_glb(file, "a.glb", notes), "a.glb");
    EXPECT_EQ(color_properties(again.vertices).size(), std::string(alpha) == "255" ? 3u : 4u);
    EXPECT_EQ(values(again.vertices, "blue"), (std::vector<double>{3, 3, 3}));
  }
}

TEST(Read_glb, refuses_what_is_damaged_and_names_it)
{
  EXPECT_EQ(message("glTF"), "a.glb: is not a GLB file of version 2");
  EXPECT_EQ(message(glb(triangle, "")),
            "a.glb: is not a whole GLB file: buffers[0] ends before bufferViews[0]");
  EXPECT_EQ(message(glb("{", "")),
            "a.glb: is not a GLB file: byte 5 of its JSON chunk is not as JSON defines it");
  EXPECT_EQ(message(with("\"count\":3", "\"count\":4")),
            "a.glb: bufferViews[0] is too short for 4 rows");
  EXPECT_EQ(message(with("\"bufferView\":0,\"componentType\":5126,\"type\":\"VEC3\",\"count\":3",
                         "\"componentType\":5126,\"type\":\"VEC3\",\"count\":3000000000")),
            "a.glb: accessors[0] has 3000000000 rows, wanted no more than the file has bytes");
  EXPECT_EQ(message(with("5126", "5000")), "a.glb: accessors[0] is of an unknown type");
  EXPECT_EQ(message(with("\"mesh\":0,", "\"children\":[0],")),
            "a.glb: nodes[0] is below itself, or below two others");
  EXPECT_EQ(message(with("\"POSITION\":0", "\"POSITION\":7")),
            "a.glb: is not a whole GLB file: accessors[7] is not there");
  EXPECT_EQ(message(with("\"POSITION\":0", "\"POSITION\":\"0\"")),
            "a.glb: is not a GLB file: materials[0] is not as glTF 2.0 defines it");
  const std::string whole = glb(triangle, three_points());
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(message(whole.substr(0, size)), "no error") << size;
}

/// 64 nodes, of which each is twice below the one before: 2^63 ways to the last one
// JSON has one kind of number. Conversions beyond the range of integers are undefined.
TEST(Read_glb, reads_whole_numbers_in_any_notation_and_refuses_others_where_they_are_wanted)
{
  const auto with = [](const std::string& before, const std::string& after) {
    std::string json = triangle;
    return glb(json.replace(json.find(before), before.size(), after), three_points());
  };
  EXPECT_EQ(parse_glb(with("\"count\":3", "\"count\":3.0"), "a.glb").points.size(), 3);
  for (const std::string place : {"\"count\":3", "\"componentType\":5126", "\"bufferView\":0",
                                  "\"POSITION\":0", "\"nodes\":[0", "\"scene\":0", "\"mesh\":0"})
    for (const std::string number : {"1e300", "-1e300", "-0.5", "2.5", "-1", "null", "\"0\""}) {
      const std::string wrong = place.substr(0, place.find_last_of(":[") + 1) + number;
      EXPECT_THROW(parse_glb(with(place, wrong), "a.glb"), Read_error) << wrong;
    }
}

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
