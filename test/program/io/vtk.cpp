// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests examples/conformal/io/vtk/read_vtk.cpp examples/conformal/io/vtk/write_vtk.cpp
// Tests examples/conformal/io/vtk/read_vtp.cpp examples/conformal/io/vtk/write_vtp.cpp
// Tests examples/conformal/io/vtk/Poly_data.cpp examples/conformal/io/vtk/Poly_data_builder.cpp
// Tests examples/conformal/io/vtk/inflate_blocks.cpp examples/conformal/io/usd/write_usda.cpp
#include "conformal/io/vtk/read_vtk.h"

#include "program/io/io_support.h"

#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/file/base64.h"
#include "conformal/io/glb/read_glb.h"
#include "conformal/io/glb/write_glb.h"
#include "conformal/io/obj/read_obj.h"
#include "conformal/io/ply/read_ply.h"
#include "conformal/io/usd/write_usda.h"
#include "conformal/io/vtk/read_vtp.h"
#include "conformal/io/vtk/write_vtk.h"
#include "conformal/io/vtk/write_vtp.h"
#include "tools/fuzz_readers_seeds.h"

#include <functional>
#include <limits>

namespace cgp_test::vtk_tests {

using namespace io_test;
using namespace conformal;

using Encode = std::string (*)(const Surface_file&, std::vector<std::string>&);
using Parse = Surface_file (*)(std::string_view, const std::string&, Bad_faces);

struct Vtk_format {
  Encode encode;
  Parse parse;
};

const Vtk_format both_formats[] = {{encode_vtk, parse_vtk}, {encode_vtp, parse_vtp}};

std::string replaced(std::string text, const std::string& what, const std::string& other)
{
  return text.replace(text.find(what), what.size(), other);
}

/// a triangle and a quadrangle with values of all types at vertices and faces
Surface_file surface()
{
  Surface_file file = parse_obj(
      "v 0 0 0\nv 1 0 0.1\nv 1 1 1e-300\nv 0 1 0\nv .5 2 -3\nf 1 2 3 4\nf 4 3 5\n", "a.obj");
  for (const Value_type type :
       {Value_type::int8, Value_type::uint8, Value_type::int16, Value_type::uint16,
        Value_type::int32, Value_type::uint32, Value_type::float32, Value_type::float64}) {
    Property column("a_" + std::string(name_of(type)), type);
    for (const double x : {1., 2., 0., 100., 7.}) column.append(is_integer(type) ? x : x / 3);
    set_property(file.vertices, column);
  }
  set_properties(file.vertices, {"nx", "ny", "nz"}, Value_type::float64,
                 std::vector<double>(15, .5));
  set_properties(file.vertices, {"red", "green", "blue"}, Value_type::uint8,
                 {255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 9, 9, 1, 2, 3});
  set_properties(file.vertices, {"wind_0", "wind_1", "wind_2"}, Value_type::float32,
                 std::vector<double>(15, .25));
  set_properties(file.vertices, {"texture_u", "texture_v"}, Value_type::float64,
                 {0, 0, 1, 0, 1, 1, 0, 1, .1, .2});
  set_property(file.faces, "100%", std::vector<double>{1, std::numeric_limits<double>::infinity()});
  set_property(file.faces, "a<\"b\"&c", std::vector<float>{.1f, -2});
  return file;
}

TEST(Vtk, comes_back_as_it_was)
{
  const Surface_file file = surface();
  for (const auto& [encode, parse] : both_formats) {
    std::vector<std::string> notes;
    const Surface_file again = parse(encode(file, notes), "a", Bad_faces::refused);
    EXPECT_TRUE(notes.empty()) << notes[0];
    EXPECT_EQ(again.points, file.points);
    EXPECT_EQ(again.polygons.corners, file.polygons.corners);
    EXPECT_EQ(again.polygons.first, file.polygons.first);
    EXPECT_EQ(types(again.vertices), types(file.vertices));
    EXPECT_EQ(types(again.faces), types(file.faces));
    for (const Property& property : file.vertices.properties)
      EXPECT_EQ(values(again.vertices, property.name()), values(file.vertices, property.name()));
    for (const Property& property : file.faces.properties)
      EXPECT_EQ(values(again.faces, property.name()), values(file.faces, property.name()));
  }
}

TEST(Vtk, has_texture_coordinates_of_corners_where_they_do_not_jump)
{
  const std::string obj =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt .5 .5\n";
  for (const auto& [encode, parse] : both_formats) {
    std::vector<std::string> notes;
    const auto whole = parse_obj(obj + "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n", "a.obj");
    const auto again = parse(encode(whole, notes), "a", Bad_faces::refused);
    EXPECT_EQ(values(again.vertices, "texture_u"), (std::vector<double>{0, 1, 1, 0}));
    EXPECT_TRUE(notes.empty());
    encode(parse_obj(obj + "f 1/1 2/2 3/3\nf 1/5 3/3 4/4\n", "a.obj"), notes);
    EXPECT_EQ(notes,
              (std::vector<std::string>{"texture coordinates with seams are not written to VTK"}));
  }
}

TEST(Read_vtk, reads_texts_of_all_versions_and_bytes)
{
  const Surface_file old = parse_vtk(fuzz::vtk_seeds()[0], "a.vtk");
  EXPECT_EQ(old.points[2], (Point{1, 1, 0}));
  EXPECT_EQ(old.polygons.corners, (std::vector<int>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(types(old.vertices),
            "rho:double wind_0:float wind_1:float wind_2:float texture_u:float texture_v:float "
            "red:uchar green:uchar blue:uchar");
  EXPECT_EQ(values(old.vertices, "rho"), (std::vector<double>{0, .5, 1, 2}));
  EXPECT_EQ(values(old.vertices, "wind_1"), (std::vector<double>{0, 1, 0, 1}));
  EXPECT_EQ(values(old.vertices, "green"), (std::vector<double>{0, 255, 0, 128}));
  EXPECT_EQ(values(old.faces, "an_id"), (std::vector<double>{7, 8}));  // the line has the first row
  EXPECT_EQ(old.notes.size(), 1u);                                     // the line
  const Surface_file recent = parse_vtk(fuzz::vtk_seeds()[1], "a.vtk");
  EXPECT_EQ(corners(recent, 1), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(types(recent.vertices), "nx:double ny:double nz:double id:int");
  EXPECT_EQ(values(recent.vertices, "id"), (std::vector<double>{1, 2, 3, 4}));
  const Surface_file bytes = parse_vtk(fuzz::vtk_seeds()[2], "a.vtk");
  EXPECT_EQ(bytes.points, old.points);
  EXPECT_EQ(bytes.polygons.corners, old.polygons.corners);
  EXPECT_EQ(values(bytes.vertices, "rho"), values(old.vertices, "rho"));
}

TEST(Read_vtp, reads_texts_and_appended_bytes)
{
  const Surface_file text = parse_vtp(fuzz::vtp_seeds()[0], "a.vtp");
  EXPECT_EQ(text.polygons.corners, (std::vector<int>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(values(text.vertices, "texture_v"), (std::vector<double>{0, 0, 1, 1}));
  EXPECT_EQ(values(text.faces, "a&b"), (std::vector<double>{1, 2}));
  const std::string raw = fuzz::vtp_seeds()[1];
  const std::vector<double> rho = {.5, 1, 2, 3};
  EXPECT_EQ(values(parse_vtp(raw, "a.vtp").vertices, "rho"), rho);
  const std::size_t begin = raw.find("\n_") + 2;
  const std::string bytes = raw.substr(begin, 20);
  const std::string coded =
      replaced(replaced(raw, "encoding=\"raw\"", "encoding=\"base64\""), bytes, base64(bytes));
  EXPECT_EQ(values(parse_vtp(coded, "a.vtp").vertices, "rho"), rho);
  const std::string packed = fuzz::vtp_seeds()[2];
  EXPECT_EQ(values(parse_vtp(packed, "a.vtp").vertices, "rho"), rho);
  const std::string cut = replaced(packed, "</AppendedData>", "");
  EXPECT_NE(message_of([&] { (void)parse_vtp(replaced(cut, "AAAMegG/", "AAAAAAA="), "a.vtp"); }),
            "no error");
}

TEST(Read_vtk, refuses_what_it_cannot_read)
{
  const auto refusal = [](std::size_t seed, const char* what, const char* other) {
    const std::string text = replaced(fuzz::vtk_seeds()[seed], what, other);
    return message_of([&] { (void)parse_vtk(text, "a.vtk"); });
  };
  EXPECT_EQ(refusal(0, "POLYDATA", "STRUCTURED_GRID"),
            "a.vtk:4: holds another dataset than POLYDATA, which is wanted");
  EXPECT_EQ(refusal(0, "1 1 0 0 1 0", "1 1 x 0 1 0"), "a.vtk:7: 'x' is not a number");
  EXPECT_EQ(refusal(0, "1 1 0 0 1 0", "1 1 inf 0 1 0"),
            "a.vtk:6: a coordinate of point 2 is not finite");
  EXPECT_EQ(refusal(0, "3 0 2 3", "3 0 2 4"),
            "a.vtk:10: polygon 1: a face has the vertex index 4, wanted 0 to 3");
  EXPECT_EQ(refusal(0, "3 0 2 3", "5 0 2 3"),
            "a.vtk:12: polygon 1 has more corners than the table");
  EXPECT_EQ(refusal(0, "VECTORS", "SPINORS"), "a.vtk:17: 'spinors' is not a keyword of VTK");
  EXPECT_EQ(refusal(1, "0 3 7", "0 9 7"), "a.vtk:11: polygon 0: its corners are not in the table");
}

TEST(Read_vtp, refuses_what_it_cannot_read)
{
  const auto refusal = [](const char* what, const char* other) {
    const std::string text = replaced(fuzz::vtp_seeds()[0], what, other);
    return message_of([&] { (void)parse_vtp(text, "a.vtp"); });
  };
  EXPECT_EQ(refusal("PolyData\"", "ImageData\""), "a.vtp:2: holds 'ImageData', wanted PolyData");
  const std::string packed =
      replaced(fuzz::vtp_seeds()[1], "PolyData\"", "PolyData\" compressor=\"z\"");
  EXPECT_EQ(
      message_of([&] { (void)parse_vtp(packed, "a.vtp"); }),
      "a.vtp:4: is compressed by z in a way that is not read; try: Compressor Type None where "
      "it is written");
  EXPECT_EQ(refusal("1 1 0 0 1 0", "1 1 0 0 y 0"), "a.vtp:4: 'y' is not a number");
  EXPECT_EQ(refusal("3 6", "3 7"), "a.vtp: polygon 1: its corners are not in the table");
}

TEST(Write_usda, has_a_list_for_each_thing_and_notes_nothing_else)
{
  std::vector<std::string> notes;
  const std::string text = encode_usda(surface(), "a.usda", notes);
  EXPECT_TRUE(notes.empty());
  for (const char* line :
       {"point3f[] points = [(0, 0, 0), (1, 0, 0.1), (1, 1, 0), (0, 1, 0), (0.5, 2, -3)]\n",
        "int[] faceVertexCounts = [4, 3]\n", "int[] faceVertexIndices = [0, 1, 2, 3, 3, 2, 4]\n",
        "texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1), (0.1, 0.2)] (\n",
        "int[] primvars:st:indices = [0, 1, 2, 3, 3, 2, 4]\n",
        "color3f[] primvars:displayColor = [(1, 0, 0), (0, 1, 0), ",
        "float[] primvars:_100_ = [1, inf] (\n            interpolation = \"uniform\"\n",
        "int[] primvars:a_uchar = [1, 2, 0, 100, 7] (\n            interpolation = \"vertex\"\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << text;
  Surface_file large = surface();
  large.points[1][0] = 1e39;
  EXPECT_EQ(message_of<Write_error>([&] { (void)encode_usda(large, "a.usda", notes); }),
            "a.usda: vertex 1 does not fit into USD, whose points are floats");
}

TEST(Gltf, is_the_surface_of_the_glb_file)
{
  std::vector<std::string> notes;
  const Surface_file file = surface();
  const Surface_file text = parse_glb(encode_gltf(file, "a.gltf", notes), "a.gltf");
  const Surface_file binary = parse_glb(encode_glb(file, "a.glb", notes), "a.glb");
  EXPECT_EQ(text.points, binary.points);
  EXPECT_EQ(text.polygons.corners, binary.polygons.corners);
  EXPECT_EQ(types(text.vertices), types(binary.vertices));
}

TEST(Gltf, reads_numbers_from_a_file_beside_it_and_from_nowhere_else)
{
  const Folder folder;
  std::vector<std::string> notes;
  const std::string text = encode_gltf(surface(), "a.gltf", notes);
  const std::string begin = "data:application/octet-stream;base64,";
  const std::size_t at = text.find(begin), end = text.find('"', at);
  put_file(folder / "a.bin", from_base64(text.substr(at + begin.size(), end - at - begin.size())));
  const auto with = [&](const std::string& uri) {
    return std::string(text).replace(at, end - at, uri);
  };
  EXPECT_EQ(parse_glb(with("a.bin"), folder / "a.gltf").points, parse_glb(text, "a.gltf").points);
  for (const char* uri : {"../a.bin", "/a.bin", "..%2fa.bin", "file:a.bin"})
    EXPECT_NE(message_of([&] {
                (void)parse_glb(with(uri), folder / "a.gltf");
              }).find("wanted a GLB file"),
              std::string::npos);
}

}  // namespace cgp_test::vtk_tests
