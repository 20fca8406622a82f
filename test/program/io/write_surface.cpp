// Tests examples/conformal/io/write_surface.cpp examples/conformal/io/require_written.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/write_surface.h"

#include "conformal/io/read_surface.h"
#include "conformal/io/require_written.h"
#include "program/io/io_support.h"
#include "tools/fuzz_readers_seeds.h"

#include <clocale>

namespace cgp_test::write_surface_tests {

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

TEST(Write_surface, compares_what_it_has_written_with_what_was_meant)
{
  const Surface_file meant = parse_surface(fuzz::off_seeds()[0], "a.off");
  std::vector<std::string> notes;
  const auto fault = [&](const std::string& bytes) {
    return message_of<conformal::Write_error>(
        [&] { conformal::require_written("b.off", meant, bytes, notes); });
  };
  const std::string good = fuzz::off_seeds()[0];
  EXPECT_EQ(fault(good), "no error");
  std::string moved = good, fewer = good;
  moved.replace(moved.find("1 0 0"), 5, "1.0000000000000002 0 0");
  EXPECT_EQ(fault(moved), "b.off: a corner of triangle 0 does not fit into the file");
  fewer.replace(fewer.find("4 4 6"), 5, "4 3 6");
  fewer.erase(fewer.find("3 1 2"));
  EXPECT_EQ(fault(fewer), "b.off: 3 triangles were written, wanted 4");
  EXPECT_NE(fault(good.substr(0, 40)).find("cannot be read"), std::string::npos);
}

/// moved and then scaled
Surface_file placed(double shift, double scale)
{
  Surface_file file = parse_surface(fuzz::off_seeds()[0], "a.off");
  for (Point& point : file.points)
    for (double& x : point) x = scale * (x + shift);
  return file;
}

TEST(Write_surface, refuses_what_single_precision_cannot_hold)
{
  const Folder folder;
  const auto fault = [&](const char* name, double shift, double scale) {
    return message_of<conformal::Write_error>(
        [&] { write_surface(folder / name, placed(shift, scale)); });
  };
  for (const char* name : {"a.stl", "a.glb"}) {
    for (const double scale : {1e-30, 1., 1e30}) EXPECT_EQ(fault(name, 0, scale), "no error");
    for (const double scale : {1e-150, 1e-46, 1e-41, 1e46, 1e150})
      EXPECT_NE(fault(name, 0, scale), "no error") << name << scale;
  }
  EXPECT_NE(fault("b.stl", 1e9, 1).find("single precision; try: .ply"), std::string::npos);
  EXPECT_EQ(fault("b.glb", 1e9, 1), "no error");  // it has the middle apart
  EXPECT_EQ(fault("b.ply", 1e9, 1e-150), "no error");
  EXPECT_EQ(folder.size(), 4u);
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
  EXPECT_EQ(
      message("mesh"),
      "mesh: has no known extension, wanted .ply, .off, .obj, .glb, .gltf, .stl, .vtk, .vtp or "
      ".usda");
}

}  // namespace cgp_test::write_surface_tests
