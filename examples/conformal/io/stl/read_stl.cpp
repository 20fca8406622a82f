// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_stl.h"

#include "conformal/io/data/Vertex_merger.h"
#include "conformal/io/file/Text_scanner.h"
#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/little_endian.h"
#include "conformal/io/file/numbers.h"
#include "conformal/io/file/read_bytes.h"

#include <cctype>
#include <cmath>

namespace conformal {
namespace {

constexpr std::size_t header_size = 84, facet_size = 50;  // bytes

Surface_file stl_file(const std::string& path)
{
  Surface_file file;
  file.path = path;
  file.format = File_format::stl;
  return file;
}

std::string fault_of_facet(const std::array<std::int64_t, 3>& corners, Bad_faces bad_faces)
{
  const bool degenerate =
      corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
  if (!degenerate || bad_faces == Bad_faces::kept) return "";
  return "a facet has two equal corners, wanted three different ones; try: --repair";
}

bool are_equal(std::string_view word, std::string_view lower_case)
{
  if (word.size() != lower_case.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (std::tolower(static_cast<unsigned char>(word[i])) != lower_case[i]) return false;
  return true;
}

class Ascii_stl_reader {
 public:
  Ascii_stl_reader(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
      : m_file(stl_file(path)),
        m_scanner(bytes, path, Text_scanner::plain),
        m_bad_faces(bad_faces),
        m_merger(m_file.points)
  {
    while (!m_scanner.at_end()) read_solid();
    if (m_file.polygons.size() == 0) m_scanner.fail("no facets, wanted a surface");
    m_file.vertices.size = m_file.points.size();
    m_file.faces.size = m_file.polygons.size();
  }

  Surface_file take() { return std::move(m_file); }

 private:
  void expect(const char* lower_case)
  {
    const std::string_view word = m_scanner.word(lower_case);
    if (!are_equal(word, lower_case)) m_scanner.fail(in_quotes(word) + ", wanted " + lower_case);
  }

  void read_solid()
  {
    expect("solid");
    const std::string_view name = m_scanner.rest_of_line();
    if (!name.empty()) m_file.comments.push_back("solid " + std::string(name));
    for (;;) {
      const std::string_view word = m_scanner.word("facet or endsolid");
      if (are_equal(word, "endsolid")) break;
      if (!are_equal(word, "facet")) m_scanner.fail(in_quotes(word) + ", wanted facet or endsolid");
      read_facet();
    }
    m_scanner.rest_of_line();
  }

  void read_facet()
  {
    const std::size_t line = m_scanner.line();
    expect("normal");
    for (int i = 0; i < 3; ++i) m_scanner.number("a normal");  // nan is common, and harmless
    expect("outer");
    expect("loop");
    std::array<std::int64_t, 3> corners;
    for (std::int64_t& corner : corners) {
      expect("vertex");
      Point point;
      for (double& x : point) x = m_scanner.coordinate("a coordinate");
      corner = m_merger.vertex(point);
    }
    expect("endloop");
    expect("endfacet");
    const std::string fault = fault_of_facet(corners, m_bad_faces);
    if (!fault.empty()) m_scanner.fail_at(line, fault);
    append_face(m_file.polygons, corners.data(), corners.data() + 3);
  }

  Surface_file m_file;
  Text_scanner m_scanner;
  Bad_faces m_bad_faces;
  Vertex_merger m_merger;
};

std::uint32_t announced_facets(std::string_view bytes)
{
  return little_endian<std::uint32_t>(bytes.data() + header_size - 4);
}

Point facet_corner(const char* bytes, std::size_t facet, const std::string& path)
{
  Point point;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = static_cast<double>(little_endian<float>(bytes + 4 * i));
    if (!std::isfinite(point[i]))
      throw Read_error(path, 0,
                       "facet " + std::to_string(facet) +
                           " has a coordinate that is not finite, wanted a coordinate");
  }
  return point;
}

void read_facets(std::string_view bytes, const std::string& path, Bad_faces bad_faces,
                 Surface_file& file)
{
  Vertex_merger merger(file.points);
  Property attributes("attribute", Value_type::uint16);
  bool has_attributes = false;
  for (std::size_t f = 0; f < file.faces.size; ++f) {
    const char* facet = bytes.data() + header_size + facet_size * f;
    std::array<std::int64_t, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = merger.vertex(facet_corner(facet + 12 + 12 * i, f, path));
    const std::string fault = fault_of_facet(corners, bad_faces);
    if (!fault.empty()) throw Read_error(path, 0, "facet " + std::to_string(f) + ": " + fault);
    append_face(file.polygons, corners.data(), corners.data() + 3);
    attributes.append(little_endian<std::uint16_t>(facet + 48));
    has_attributes = has_attributes || attributes.value(f) != 0;
  }
  file.vertices.size = file.points.size();
  if (has_attributes) set_property(file.faces, std::move(attributes));
}

Surface_file parse_binary_stl(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  if (bytes.size() < header_size)
    throw Read_error(path, 0,
                     "is not an STL file: it has " + std::to_string(bytes.size()) +
                         " bytes and does not begin with solid");
  const std::size_t facets = announced_facets(bytes), size = header_size + facet_size * facets;
  if (bytes.size() < size)
    throw Read_error(path, 0,
                     "is not a whole STL file: " + std::to_string(facets) + " facets need " +
                         std::to_string(size) + " bytes, but it has " +
                         std::to_string(bytes.size()));
  const std::size_t surplus = bytes.size() - size;
  if (surplus >= facet_size)  // the number may be wrong
    throw Read_error(path, 0,
                     "announces " + std::to_string(facets) + " facets, but " +
                         std::to_string(surplus) + " bytes follow them, wanted the right number");
  if (facets == 0) throw Read_error(path, 0, "no facets, wanted a surface");
  // A facet has three corners, which may all be different vertices, and these are counted by int.
  if (facets > 715827882)
    throw Read_error(path, 0, "more than 715827882 facets, the limit for STL");
  Surface_file file = stl_file(path);
  file.faces.size = facets;
  if (surplus > 0)
    file.notes.push_back("left out: " + std::to_string(surplus) + " bytes after the last facet");
  read_facets(bytes, path, bad_faces, file);
  return file;
}

// Binary files may begin with solid too; what gives them away, if they are cut off, is a zero byte,
// of the number of facets or later.
bool is_ascii_stl(std::string_view bytes)
{
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos || !are_equal(bytes.substr(begin, 5), "solid")) return false;
  return bytes.size() < header_size || bytes.find('\0', header_size - 4) == std::string_view::npos;
}

}  // namespace

bool is_binary_stl(std::string_view bytes)
{
  return bytes.size() >= header_size &&
         bytes.size() == header_size + facet_size * std::size_t{announced_facets(bytes)};
}

Surface_file parse_stl(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  bytes = checked_bytes(bytes, path);
  if (is_binary_stl(bytes)) return parse_binary_stl(bytes, path, bad_faces);
  return is_ascii_stl(bytes) ? Ascii_stl_reader(bytes, path, bad_faces).take()
                             : parse_binary_stl(bytes, path, bad_faces);
}

Surface_file read_stl(const std::string& path)
{
  return parse_stl(read_bytes(path), path);
}

}  // namespace conformal
