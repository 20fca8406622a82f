// Tests examples/conformal/io/data/texture_coordinates.cpp
// Tests examples/conformal/io/data/Surface_file.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/data/texture_coordinates.h"

#include "conformal/io/obj/read_obj.h"
#include "conformal/io/ply/read_ply.h"
#include "program/io/io_support.h"
#include "tools/fuzz_readers_seeds.h"

#include <stdexcept>

namespace cgp_test::texture_coordinates_tests {

using namespace conformal;
using namespace io_test;

using Row = std::array<double, 3>;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Texture_coordinates, of_obj_are_its_own)
{
  const Surface_file file = parse_obj(
      square + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 5\nf 1/1 2/2 3/3\nf 1/5 3/3 4/4\n", "a.obj");
  const Corner_values texture = texture_coordinates(file);
  EXPECT_EQ(texture.index, (std::vector<int>{0, 1, 2, 4, 2, 3}));
  EXPECT_FALSE(vertex_values(file, texture)) << "vertex 1 has a seam";
}

TEST(Texture_coordinates, of_vertices_have_any_of_three_names)
{
  const std::string text = fuzz::ply_seeds()[0];
  for (const auto& [u, v] : {std::pair("texture_u", "texture_v"), {"s", "t"}, {"u", "v"}}) {
    Surface_file file = parse_ply(text, "a.ply");
    remove_property(file.faces, "texcoord");
    remove_property(file.vertices, "texture_u");
    remove_property(file.vertices, "texture_v");
    EXPECT_TRUE(texture_coordinates(file).empty());
    set_property(file.vertices, u, std::vector<float>{0, 1, 2, 3});
    EXPECT_TRUE(texture_coordinates(file).empty());
    set_property(file.vertices, v, std::vector<float>{4, 5, 6, 7});
    const auto rows = vertex_values(file, texture_coordinates(file));
    ASSERT_TRUE(rows);
    EXPECT_EQ((*rows)[3], (Row{3, 7, 0}));
  }
}

TEST(Texture_coordinates, of_faces_may_be_missing_and_share_equal_rows)
{
  const Surface_file file = parse_ply(fuzz::ply_seeds()[0], "a.ply");
  const Corner_values texture = texture_coordinates(file);
  EXPECT_EQ(texture.index, (std::vector<int>{0, 1, 2, -1, -1, -1}));
  EXPECT_EQ(texture.values[2], (Row{1, 1, 0}));
  EXPECT_FALSE(vertex_values(file, texture)) << "the second face has none";
}

TEST(Texture_coordinates, replace_all_others)
{
  Surface_file file = parse_ply(fuzz::ply_seeds()[0], "a.ply");
  set_texture_coordinates(file, {{0, 1}, {2, 3}, {4, 5}, {6, 7}});
  EXPECT_EQ(find_property(file.faces, "texcoord"), nullptr);
  EXPECT_EQ(find_property(file.vertices, "texture_u"), nullptr);
  EXPECT_NE(find_property(file.vertices, "quality"), nullptr);
  EXPECT_EQ((*vertex_values(file, texture_coordinates(file)))[2], (Row{4, 5, 0}));
  set_texture_coordinates(file, Corner_values());
  EXPECT_TRUE(texture_coordinates(file).empty());
}

TEST(Texture_coordinates, of_another_size_are_refused)
{
  Surface_file file = parse_obj(square + "f 1 2 3\n", "a.obj");
  EXPECT_THROW(set_texture_coordinates(file, {{0, 0}}), std::invalid_argument);
  EXPECT_THROW(set_texture_coordinates(file, Corner_values{2, {{0, 0, 0}}, {0}}),
               std::invalid_argument);
}

TEST(Vertex_values, are_zero_where_no_face_is)
{
  const Surface_file file = parse_obj(square + "vn 0 0 1\nf 1//1 2//1 3//1\n", "a.obj");
  const auto rows = vertex_values(file, file.normals);
  ASSERT_TRUE(rows);
  EXPECT_EQ((*rows)[0], (Row{0, 0, 1}));
  EXPECT_EQ((*rows)[3], (Row{0, 0, 0}));
}

TEST(Surface_file, loses_its_normals_when_asked)
{
  Surface_file file = parse_obj(square + "vn 0 0 1\nf 1//1 2//1 3//1\n", "a.obj");
  for (const char* name : {"nx", "ny", "nz", "quality"})
    set_property(file.vertices, name, std::vector<float>(4, 1.0f));
  remove_normals(file);
  EXPECT_TRUE(file.normals.empty());
  EXPECT_EQ(types(file.vertices), "quality:float");
}

TEST(Color_properties, are_three_or_four_in_order)
{
  Element element{"vertex", 1, {}};
  for (const char* name : {"alpha", "blue", "green"})
    set_property(element, name, std::vector<float>{0.0f});
  EXPECT_TRUE(color_properties(element).empty());
  set_property(element, "red", std::vector<float>{1.0f});
  const auto colors = color_properties(element);
  ASSERT_EQ(colors.size(), 4u);
  EXPECT_EQ(colors[0]->name(), "red");
  EXPECT_EQ(colors[3]->name(), "alpha");
  remove_property(element, "alpha");
  EXPECT_EQ(color_properties(element).size(), 3u);
}

}  // namespace cgp_test::texture_coordinates_tests
