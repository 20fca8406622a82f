// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "detect_format.h"

#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/numbers.h"
#include "conformal/io/off/read_off.h"
#include "conformal/io/stl/read_stl.h"

#include <algorithm>
#include <array>

namespace conformal {
namespace {

using namespace std::string_view_literals;

bool is_obj_keyword(std::string_view word)
{
  constexpr std::array words = {"v"sv, "vn"sv, "vt"sv,     "f"sv,     "o"sv,
                                "g"sv, "s"sv,  "mtllib"sv, "usemtl"sv};
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::optional<File_format> format_of_extension(const std::string& path)
{
  constexpr std::array<std::pair<std::string_view, File_format>, 9> extensions = {
      {{".off", File_format::off},
       {".obj", File_format::obj},
       {".ply", File_format::ply},
       {".stl", File_format::stl},
       {".glb", File_format::glb},
       {".gltf", File_format::gltf},
       {".vtk", File_format::vtk},
       {".vtp", File_format::vtp},
       {".usda", File_format::usda}}};
  const std::string end =
      lower(std::string_view(path).substr(std::min(path.rfind('.'), path.size())));
  for (const auto& [extension, format] : extensions)
    if (end == extension) return format;
  return {};
}

const char* name_of(File_format format)
{
  constexpr std::array names = {"OFF", "OBJ", "PLY", "STL", "GLB", "glTF", "VTK", "VTP", "USD"};
  return names[static_cast<std::size_t>(format)];
}

File_format detect_format(std::string_view bytes, const std::string& path)
{
  if (starts_with(bytes, "glTF")) return File_format::glb;
  if (bytes.substr(0, 1000).find("<VTKFile") != bytes.npos) return File_format::vtp;
  bytes = checked_bytes(bytes, path);
  if (starts_with(bytes, "# vtk DataFile")) return File_format::vtk;
  const std::string_view word = first_word(bytes);
  if (bytes.substr(0, 3) == "ply" && word == "ply") return File_format::ply;
  if (length_of_off_keyword(first_words(bytes)) != 0) return File_format::off;
  if (is_binary_stl(bytes) || lower(word) == "solid") return File_format::stl;
  if (starts_with(word, "{")) return File_format::gltf;
  const auto format = format_of_extension(path);
  if (format == File_format::obj || (!format && is_obj_keyword(word))) return File_format::obj;
  if (format == File_format::stl) return File_format::stl;
  throw Read_error(path, 0,
                   format ? std::string("is not ") + (name_of(*format)[0] == 'O' ? "an " : "a ") +
                                name_of(*format) + " file: it begins with " + in_quotes(word)
                          : "is of no known format: it begins with " + in_quotes(word) +
                                ", wanted OFF, OBJ, PLY, GLB, glTF, VTK or STL");
}

}  // namespace conformal
