// Tests examples/conformal/io/write_surface.cpp
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/write_surface.h"

#include "conformal/io/read_surface.h"
#include "program/io/io_support.h"
#include "tools/fuzz_readers_seeds.h"

#include <clocale>

namespace {

using namespace conformal;
using namespace io_test;

TEST(Write_surface, chooses_the_format_by_the_extension)
{
  const Folder folder;
  const Surface_file file = parse_surface(fuzz::off_seeds()[0], "a.off");
  for (const std::string name : {"a.off", "a.OBJ", "a.ply"}) {
    write_surface(folder / name, file);
    const Surface_file again = read_surface(folder / name);
    EXPECT_EQ(again.points, file.points) << name;
    EXPECT_EQ(again.polygons.corners, file.polygons.corners) << name;
    EXPECT_EQ(again.format, output_format(name));
  }
  write_surface(folder / "a.glb", file);
  EXPECT_EQ(content(folder / "a.glb").substr(0, 4), "glTF");
}

TEST(Write_surface, may_replace_the_file_that_was_read)
{
  const Folder folder;
  const std::string path = folder / "a.ply";
  put_file(path, fuzz::ply_seeds()[0]);
  Surface_file file = read_surface(path);
  for (Point& point : file.points) point[2] += 1.0;
  write_surface(path, file);
  EXPECT_EQ(read_surface(path).points, file.points);
  EXPECT_EQ(folder.size(), 1u);
}

/// a column of numbers, or of lists that are empty
Property column(const char* name, bool is_list, std::size_t rows)
{
  Property column = is_list ? Property(name, Value_type::uint8, Value_type::float32)
                            : Property(name, Value_type::float32);
  for (std::size_t i = 0; i < rows; ++i) is_list ? column.end_list() : column.append(0.5);
  return column;
}

TEST(Write_surface, takes_properties_of_every_name_with_numbers_or_lists)
{
  const Folder folder;
  Surface_file file = parse_surface(fuzz::off_seeds()[0], "a.off");
  for (const bool is_list : {true, false}) {
    for (const char* name :
         {"nx", "ny", "nz", "red", "green", "blue", "alpha", "texture_u", "texture_v", "s", "t",
          "u", "v", "texcoord", "color", "attribute", "quality", "rho"}) {
      set_property(file.vertices, column(name, is_list, file.vertices.size));
      set_property(file.faces, column(name, !is_list, file.faces.size));
    }
    for (const std::string format : {"off", "obj", "ply", "glb", "stl"}) {
      const std::string path = folder / "a." + format;
      EXPECT_NO_THROW(write_surface(path, file)) << format;
      EXPECT_EQ(read_surface(path).polygons.size(), file.polygons.size()) << format;
    }
  }
}

TEST(Write_surface, does_not_depend_on_the_locale)
{
  const Folder folder;
  Surface_file file = parse_surface(fuzz::off_seeds()[0], "a.off");
  file.points[0] = {0.5, 0.25, 1e-3};
  const auto text = [&] {
    write_surface(folder / "a.off", file);
    return content(folder / "a.off");
  };
  const std::string plain = text();
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name) != nullptr) break;
  EXPECT_EQ(text(), plain);
  EXPECT_EQ(read_surface(folder / "a.off").points, file.points);
  std::setlocale(LC_ALL, "C");
}

TEST(Write_surface, refuses_formats_that_it_does_not_write)
{
  const auto message = [](const std::string& path) {
    return message_of<Write_error>([&] { write_surface(path, Surface_file()); });
  };
  EXPECT_EQ(message("mesh"), "mesh: has no known extension, wanted .ply, .off, .obj, .glb or .stl");
}

}  // namespace
