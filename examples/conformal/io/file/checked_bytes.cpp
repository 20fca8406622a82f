// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "checked_bytes.h"

#include "io_errors.h"

#include <array>
#include <cctype>

namespace conformal {
namespace {

using namespace std::string_view_literals;

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
    {"\x89PNG"sv, "is a picture (PNG), wanted OFF, OBJ, PLY, GLB, glTF, VTK or STL"},
    {"version https://git-lfs"sv,
     "is a pointer of Git LFS to the file, wanted the file itself (git lfs pull)"},
    {"%PDF"sv, "is a PDF document, wanted OFF, OBJ, PLY, GLB, glTF, VTK or STL"},
}};

void refuse_markup(std::string_view bytes, const std::string& path)
{
  const std::string word = lower(first_word(bytes.substr(0, 4096)));
  if (word.empty() || word[0] != '<') return;
  const bool is_html = starts_with(word, "<!doctype") || starts_with(word, "<html");
  throw Read_error(path, 0,
                   std::string(is_html ? "is an HTML page" : "is an XML document") +
                       ", wanted OFF, OBJ, PLY, GLB, glTF, VTK or STL");
}

}  // namespace

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

std::string_view checked_bytes(std::string_view bytes, const std::string& path)
{
  for (const Signature& signature : not_meshes)
    if (starts_with(bytes, signature.bytes)) throw Read_error(path, 0, signature.message);
  if (starts_with(bytes, "\xef\xbb\xbf")) bytes.remove_prefix(3);
  refuse_markup(bytes, path);
  return bytes;
}

}  // namespace conformal
