// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "detect_format.h"

#include "io_errors.h"
#include "numbers.h"
#include "read_stl.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace conformal {
namespace {

using namespace std::string_view_literals;

bool starts_with(std::string_view text, std::string_view prefix)
{
  return text.substr(0, prefix.size()) == prefix;
}

std::string lower(std::string_view text)
{
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// the text from its first word on, blank lines and comments skipped
std::string_view first_words(std::string_view text)
{
  for (;;) {
    const std::size_t begin = text.find_first_not_of(" \t\v\f\r\n");
    if (begin == std::string_view::npos) return {};
    text.remove_prefix(begin);
    if (text[0] != '#') return text;
    const std::size_t end = text.find_first_of("\r\n");
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end);
  }
}

std::string_view first_word(std::string_view text)
{
  text = first_words(text);
  return text.substr(0, text.find_first_of(" \t\v\f\r\n"));
}

struct Signature {
  std::string_view bytes;
  const char* message;
};

constexpr std::array<Signature, 11> not_meshes = {{
    {"\x1f\x8b"sv, "is compressed with gzip, wanted the unpacked file (gunzip it)"},
    {"PK\x03\x04"sv, "is a ZIP archive, wanted the unpacked file (unzip it)"},
    {"BZh"sv, "is compressed with bzip2, wanted the unpacked file (bunzip2 it)"},
    {"\xfd"
     "7zXZ"sv,
     "is compressed with xz, wanted the unpacked file (unxz it)"},
    {"\x28\xb5\x2f\xfd"sv, "is compressed with zstd, wanted the unpacked file (unzstd it)"},
    {"7z\xbc\xaf\x27\x1c"sv, "is a 7z archive, wanted the unpacked file"},
    {"\xff\xfe"sv, "is UTF-16 text, wanted UTF-8 or ASCII (convert it with iconv)"},
    {"\xfe\xff"sv, "is UTF-16 text, wanted UTF-8 or ASCII (convert it with iconv)"},
    {"glTF"sv, "is a GLB file, which is only written; wanted OFF, OBJ, PLY or STL"},
    {"\x89PNG"sv, "is a picture (PNG), wanted OFF, OBJ, PLY or STL"},
    {"%PDF"sv, "is a PDF document, wanted OFF, OBJ, PLY or STL"},
}};

void refuse_markup(std::string_view bytes, const std::string& path)
{
  const std::string word = lower(first_word(bytes.substr(0, 4096)));
  if (word.empty() || word[0] != '<') return;
  const bool is_html = starts_with(word, "<!doctype") || starts_with(word, "<html");
  throw Read_error(path, 0,
                   std::string(is_html ? "is an HTML page" : "is an XML document") +
                       ", wanted OFF, OBJ, PLY or STL");
}

bool is_obj_keyword(std::string_view word)
{
  constexpr std::array words = {"v"sv, "vn"sv, "vt"sv,     "f"sv,     "o"sv,
                                "g"sv, "s"sv,  "mtllib"sv, "usemtl"sv};
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::optional<File_format> format_of_extension(const std::string& path)
{
  constexpr std::array<std::pair<std::string_view, File_format>, 5> extensions = {
      {{".off", File_format::off},
       {".obj", File_format::obj},
       {".ply", File_format::ply},
       {".stl", File_format::stl},
       {".glb", File_format::glb}}};
  const std::string end =
      lower(std::string_view(path).substr(path.size() < 4 ? 0 : path.size() - 4));
  for (const auto& [extension, format] : extensions)
    if (end == extension) return format;
  return {};
}

const char* name_of(File_format format)
{
  constexpr std::array names = {"OFF", "OBJ", "PLY", "STL", "GLB"};
  return names[static_cast<std::size_t>(format)];
}

std::size_t length_of_off_keyword(std::string_view text)
{
  std::size_t length = 0;
  for (const std::string_view part : {"ST"sv, "C"sv, "N"sv, "4"sv, "n"sv})
    if (starts_with(text.substr(length), part)) length += part.size();
  return starts_with(text.substr(length), "OFF") ? length + 3 : 0;
}

std::string_view checked_bytes(std::string_view bytes, const std::string& path)
{
  for (const Signature& signature : not_meshes)
    if (starts_with(bytes, signature.bytes)) throw Read_error(path, 0, signature.message);
  if (starts_with(bytes, "\xef\xbb\xbf")) bytes.remove_prefix(3);
  refuse_markup(bytes, path);
  return bytes;
}

File_format detect_format(std::string_view bytes, const std::string& path)
{
  bytes = checked_bytes(bytes, path);
  const std::string_view word = first_word(bytes);
  if (bytes.substr(0, 3) == "ply" && word == "ply") return File_format::ply;
  if (length_of_off_keyword(first_words(bytes)) != 0) return File_format::off;
  if (is_binary_stl(bytes) || lower(word) == "solid") return File_format::stl;
  const auto format = format_of_extension(path);
  if (format == File_format::obj || (!format && is_obj_keyword(word))) return File_format::obj;
  if (format == File_format::stl) return File_format::stl;
  throw Read_error(path, 0,
                   format ? std::string("is not ") + (format == File_format::ply ? "a " : "an ") +
                                name_of(*format) + " file: it begins with " + in_quotes(word)
                          : "is of no known format: it begins with " + in_quotes(word) +
                                ", wanted OFF, OBJ, PLY or STL");
}

}  // namespace conformal
