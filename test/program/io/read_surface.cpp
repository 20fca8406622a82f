// Tests examples/conformal/io/read_surface.cpp examples/conformal/io/detect_format.cpp
// Tests examples/conformal/io/file/read_bytes.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/read_surface.h"

#include "program/io/io_support.h"
#include "tools/fuzz_readers_seeds.h"

#include <unistd.h>

namespace cgp_test::read_surface_tests {

using namespace conformal;
using namespace io_test;

std::string refusal(const std::string& text, const std::string& path)
{
  return message_of([&] { parse_surface(text, path); });
}

TEST(Read_surface, knows_the_format_by_its_content)
{
  for (const std::string path : {"mesh", "mesh.obj", "mesh.txt"}) {
    EXPECT_EQ(parse_surface(fuzz::off_seeds()[1], path).format, File_format::off);
    EXPECT_EQ(parse_surface(fuzz::ply_seeds()[0], path).format, File_format::ply);
    EXPECT_EQ(parse_surface(fuzz::stl_seeds()[0], path).format, File_format::stl);
    EXPECT_EQ(parse_surface(fuzz::stl_seeds()[1], path).format, File_format::stl);
    EXPECT_EQ(parse_surface(fuzz::obj_seeds()[0], path).format, File_format::obj);
  }
}

TEST(Read_surface, knows_an_obj_file_of_unusual_beginning_by_its_extension)
{
  const std::string text = "vp 0 0\n" + fuzz::obj_seeds()[1];
  EXPECT_EQ(parse_surface(text, "mesh.OBJ").format, File_format::obj);
  EXPECT_EQ(refusal(text, "mesh"),
            "mesh: is of no known format: it begins with 'vp', wanted OFF, OBJ, PLY, GLB, glTF, "
            "VTK or STL");
}

TEST(Read_surface, accepts_a_byte_order_mark_in_every_text_format)
{
  const std::string mark = "\xef\xbb\xbf";
  EXPECT_EQ(parse_surface(mark + fuzz::off_seeds()[0], "a.off").points.size(), 4u);
  EXPECT_EQ(parse_surface(mark + fuzz::obj_seeds()[0], "a.obj").points.size(), 4u);
  EXPECT_EQ(parse_surface(mark + fuzz::ply_seeds()[0], "a.ply").points.size(), 4u);
  EXPECT_EQ(parse_surface(mark + fuzz::stl_seeds()[0], "a.stl").points.size(), 4u);
}

TEST(Read_surface, names_what_is_no_mesh)
{
  const std::vector<std::pair<std::string, std::string>> files = {
      {"\x1f\x8b\x08", "a: is compressed with gzip, wanted the unpacked file (gunzip it)"},
      {"PK\x03\x04", "a: is a ZIP archive, wanted the unpacked file (unzip it)"},
      {"BZh9", "a: is compressed with bzip2, wanted the unpacked file (bunzip2 it)"},
      {std::string("\xfd") + "7zXZ",
       "a: is compressed with xz, wanted the unpacked file (unxz it)"},
      {"\x28\xb5\x2f\xfd", "a: is compressed with zstd, wanted the unpacked file (unzstd it)"},
      {std::string("\xff\xfev\0", 4),
       "a: is UTF-16 text, wanted UTF-8 or ASCII (convert it with iconv)"},
      {std::string("\xfe\xff\0v", 4),
       "a: is UTF-16 text, wanted UTF-8 or ASCII (convert it with iconv)"},
      {"\n<!DOCTYPE html>", "a: is an HTML page, wanted OFF, OBJ, PLY, GLB, glTF, VTK or STL"},
      {"<html>", "a: is an HTML page, wanted OFF, OBJ, PLY, GLB, glTF, VTK or STL"},
      {"<?xml version='1.0'?>",
       "a: is an XML document, wanted OFF, OBJ, PLY, GLB, glTF, VTK or STL"},
      {"glTF\2", "a: is not a GLB file of version 2"},
      {"\x89PNG", "a: is a picture (PNG), wanted OFF, OBJ, PLY, GLB, glTF, VTK or STL"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:0\n",
       "a: is a pointer of Git LFS to the file, wanted the file itself (git lfs pull)"},
      {"%PDF-1.4", "a: is a PDF document, wanted OFF, OBJ, PLY, GLB, glTF, VTK or STL"},
      {"hello",
       "a: is of no known format: it begins with 'hello', wanted OFF, OBJ, PLY, GLB, glTF, VTK or "
       "STL"}};
  for (const auto& [text, message] : files) EXPECT_EQ(refusal(text, "a"), message);
  EXPECT_EQ(refusal("hello", "a.off"), "a.off: is not an OFF file: it begins with 'hello'");
  EXPECT_EQ(refusal("hello", "a.ply"), "a.ply: is not a PLY file: it begins with 'hello'");
  EXPECT_EQ(
      refusal("hello", "a.obj"),
      "a.obj:1: no vertices, wanted a surface; left out: 'hello' statements (1, first: line 1)");
}

TEST(Read_surface, reads_a_file_of_any_name)
{
  const Folder folder;
  std::string long_name = folder / "deep";
  for (int i = 0; i < 3; ++i) long_name += '/' + std::string(90, 'x');
  std::filesystem::create_directories(long_name);
  for (const std::string& path : {folder / "with blanks.off",
                                  folder / "Fl\xc3\xa4"
                                           "che.off",
                                  long_name + "/a.off"}) {
    put_file(path, fuzz::off_seeds()[0]);
    EXPECT_EQ(read_surface(path).points.size(), 4u) << path;
    EXPECT_EQ(read_surface(path).path, path);
  }
}

TEST(Read_surface, says_why_a_file_cannot_be_read)
{
  const Folder folder;
  const auto message = [](const std::string& path) {
    return message_of([&] { read_surface(path); });
  };
  const std::string path = folder / "a.off";
  EXPECT_EQ(message(path), path + ": cannot be opened: No such file or directory");
  put_file(path, "");
  EXPECT_EQ(message(path), path + ": is empty, wanted a mesh file");
  EXPECT_EQ(message(folder.path().string()),
            folder.path().string() + ": is a directory, wanted a mesh file");
}

TEST(Read_surface, refuses_more_than_its_limit_before_reading)
{
  const Folder folder;
  const std::string path = folder / "sparse.off";
  put_file(path, "OFF\n");
  ASSERT_EQ(::truncate(path.c_str(), (off_t{1} << 34) + 1), 0);  // takes no space on the disk
  EXPECT_EQ(message_of([&] { read_surface(path); }),
            path + ": is larger than 16 GiB, the limit for files");
}

TEST(Read_surface, tells_the_line_of_an_error)
{
  try {
    parse_surface("OFF\n3 1 0\n0 0 x\n", "a.off");
    FAIL() << "no error";
  } catch (const Read_error& error) {
    EXPECT_EQ(error.line(), 2u);
  }
}

}  // namespace cgp_test::read_surface_tests
