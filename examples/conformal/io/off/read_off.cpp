// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_off.h"

#include "conformal/io/data/Left_out.h"
#include "conformal/io/file/Text_scanner.h"
#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/numbers.h"
#include "conformal/io/file/read_bytes.h"

#include <algorithm>
#include <cmath>

namespace conformal {
namespace {

// Numbers that follow the geometry on a line: colours, mostly.
struct Extra_numbers {
  std::vector<double> values;
  std::vector<std::size_t> first = {0};
  std::vector<bool> is_integer;  // by its spelling: 1 is not 1.0

  std::size_t count(std::size_t row) const { return first[row + 1] - first[row]; }

  void shorten_last(std::size_t count)
  {
    first.back() = first[first.size() - 2] + count;
    values.resize(first.back());
    is_integer.resize(first.back());
  }

  bool all_counts_are(std::size_t n) const
  {
    for (std::size_t row = 0; row + 1 < first.size(); ++row)
      if (count(row) != n) return false;
    return true;
  }

  // 0..255 fit into a byte; other integers are preserved
  Value_type color_type() const
  {
    if (std::find(is_integer.begin(), is_integer.end(), false) != is_integer.end())
      return Value_type::float64;
    const auto is_byte = [](double value) { return value >= 0 && value <= 255; };
    const auto is_int = [](double value) { return std::abs(value) <= 2147483647; };
    if (std::all_of(values.begin(), values.end(), is_byte)) return Value_type::uint8;
    return std::all_of(values.begin(), values.end(), is_int) ? Value_type::int32
                                                             : Value_type::float64;
  }
};

class Off_reader {
 public:
  Off_reader(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
      : m_scanner(bytes, path, comments), m_bad_faces(bad_faces)
  {
    m_file.path = path;
    m_file.format = File_format::off;
    read_header(bytes, path);
    read_counts();
    read_vertices();
    read_faces();
    keep_comments(bytes);
    m_file.notes = m_left_out.notes();
    note_what_follows();
  }

  Surface_file take() { return std::move(m_file); }

 private:
  // The header decides, as for other readers: real files have fewer faces announced than listed.
  void note_what_follows()
  {
    if (!m_scanner.at_end())
      m_file.notes.push_back("the header announces " + std::to_string(m_file.faces.size) +
                             " faces; what follows them, from line " +
                             std::to_string(m_scanner.line()) + " on, was left out");
  }

  // In an OFF file, every `#` begins a comment.
  void keep_comments(std::string_view bytes)
  {
    std::size_t begin = bytes.find('#');
    while (begin != std::string_view::npos) {
      const std::size_t end = std::min(bytes.find_first_of("\r\n", begin), bytes.size());
      begin += begin + 1 < end && bytes[begin + 1] == ' ' ? 2 : 1;
      m_file.comments.emplace_back(bytes.substr(begin, end - begin));
      begin = bytes.find('#', end);
    }
  }

  static constexpr const char* no_colors = "values of vertices that are not colours";
  static constexpr int comments = Text_scanner::hash_comments | Text_scanner::hash_ends_words;

  void read_header(std::string_view bytes, const std::string& path)
  {
    if (m_scanner.at_end()) throw Read_error(path, 0, "has no words, wanted OFF");
    const std::string_view rest = bytes.substr(bytes.size() - m_scanner.bytes_left());
    const std::size_t length = length_of_off_keyword(rest);
    const std::string_view keyword = rest.substr(0, length);
    if (length == 0) m_scanner.fail(in_quotes(m_scanner.word("OFF")) + ", wanted the word OFF");
    if (keyword.find_first_of("4n") != std::string_view::npos)
      m_scanner.fail(std::string(keyword) + ": points are not in three dimensions, wanted OFF");
    m_has_texture = keyword.substr(0, 2) == "ST";
    m_has_normals = keyword.find('N') != std::string_view::npos;
    m_has_colors = keyword.find('C') != std::string_view::npos;
    // The counts may be glued to the keyword: real files have `OFF8 6 12`.
    m_scanner = Text_scanner(rest.substr(length), path, comments, m_scanner.line());
  }

  void read_counts()
  {
    const std::string_view word = m_scanner.word("the number of vertices");
    if (word == "BINARY") m_scanner.fail("OFF BINARY is not supported, wanted ASCII");
    const auto vertices = parse_integer(word);
    if (!vertices)
      m_scanner.fail(in_quotes(word) + " is not an integer, wanted the number of vertices");
    const std::int64_t faces = m_scanner.integer("the number of faces");
    if (!m_scanner.at_end_of_line()) m_scanner.integer("the number of edges");
    if (!m_scanner.at_end_of_line())
      m_scanner.fail(in_quotes(m_scanner.word("")) + " after the three counts, wanted a new line");
    m_scanner.check_count(*vertices, 6, "vertices");  // `0 0 0` and a blank
    m_scanner.check_count(faces, 8, "faces");         // `3 0 1 2` and a blank
    if (*vertices == 0) m_scanner.fail("no vertices, wanted a surface");
    if (faces == 0) m_scanner.fail("no faces, wanted a surface");
    m_file.vertices.size = static_cast<std::size_t>(*vertices);
    m_file.faces.size = static_cast<std::size_t>(faces);
  }

  void leave_out(std::string_view what)
  {
    m_left_out.add(what, "line " + std::to_string(m_scanner.line()));
  }

  // A row with a word that is not a number counts as empty.
  void read_extra(Extra_numbers& extra, const char* what_is_no_color)
  {
    bool all_are_numbers = true;
    while (!m_scanner.at_end_of_line()) {
      const std::string_view word = m_scanner.word("");
      const auto value = parse_double(word);
      all_are_numbers = all_are_numbers && value;
      extra.values.push_back(value.value_or(0));
      extra.is_integer.push_back(parse_integer(word).has_value());
    }
    extra.first.push_back(extra.values.size());
    if (all_are_numbers) return;
    leave_out(what_is_no_color);
    extra.shorten_last(0);
  }

  void read_vertices()
  {
    Extra_numbers extra;
    std::vector<double> normals, texture;
    for (std::size_t v = 0; v < m_file.vertices.size; ++v) {
      Point point;
      for (double& x : point) x = m_scanner.coordinate("a coordinate");
      m_file.points.push_back(point);
      for (int i = 0; m_has_normals && i < 3; ++i) normals.push_back(m_scanner.number("a normal"));
      read_extra(extra, no_colors);
      take_texture(extra, texture);
      take_colors(extra, v);
    }
    if (m_has_normals)
      set_properties(m_file.vertices, {"nx", "ny", "nz"}, Value_type::float64, normals);
    store_colors(m_file.vertices, extra);
    if (m_has_texture && texture.size() == 2 * m_file.vertices.size)
      set_properties(m_file.vertices, {"texture_u", "texture_v"}, Value_type::float64, texture);
  }

  // Texture coordinates are the last two numbers of a vertex, after its colour.
  void take_texture(Extra_numbers& extra, std::vector<double>& texture)
  {
    if (!m_has_texture) return;
    const std::size_t count = extra.count(extra.first.size() - 2);
    if (count < 2) leave_out("texture coordinates, which not all vertices have");
    if (count < 2) return extra.shorten_last(0);
    texture.insert(texture.end(), extra.values.end() - 2, extra.values.end());
    extra.shorten_last(count - 2);
  }

  // Colours are common after a plain OFF header, too.
  void take_colors(Extra_numbers& extra, std::size_t v)
  {
    const std::size_t count = extra.count(v);
    if (count != 0 && count != 3 && count != 4) {
      leave_out(no_colors);
      extra.shorten_last(0);
    } else if (count != extra.count(0) || (count == 0 && m_has_colors)) {
      leave_out("colours, which not all vertices have");
    }
  }

  void read_faces()
  {
    Extra_numbers extra;
    std::vector<std::int64_t> corners;
    for (std::size_t f = 0; f < m_file.faces.size; ++f) {
      const std::int64_t degree = m_scanner.integer("the number of corners of a face");
      const std::size_t line = m_scanner.line();
      m_scanner.check_count(degree, 2, "corners");
      corners.clear();
      while (corners.size() < static_cast<std::size_t>(degree))
        corners.push_back(m_scanner.integer("a vertex index"));
      const auto* data = corners.data();
      const std::string fault =
          fault_of_face(data, data + degree, m_file.points.size(), 0, m_bad_faces);
      if (!fault.empty()) m_scanner.fail_at(line, fault);
      append_face(m_file.polygons, data, data + degree);
      read_extra(extra, "values of faces that are not colours");
    }
    if (!store_colors(m_file.faces, extra)) store_list(extra);
  }

  static bool store_colors(Element& element, const Extra_numbers& extra)
  {
    if (extra.values.empty()) return true;
    const std::size_t count = extra.count(0);
    if ((count != 3 && count != 4) || !extra.all_counts_are(count)) return false;
    std::vector<std::string> names = {"red", "green", "blue", "alpha"};
    names.resize(count);
    set_properties(element, names, extra.color_type(), extra.values);
    return true;
  }

  void store_list(const Extra_numbers& extra)
  {
    Property colors("color", Value_type::int32, extra.color_type());
    for (std::size_t f = 0; f < m_file.faces.size; ++f) {
      for (std::size_t i = extra.first[f]; i < extra.first[f + 1]; ++i)
        colors.append(extra.values[i]);
      colors.end_list();
    }
    set_property(m_file.faces, std::move(colors));
  }

  Surface_file m_file;
  Text_scanner m_scanner;
  Bad_faces m_bad_faces;
  Left_out m_left_out;
  bool m_has_texture = false, m_has_normals = false, m_has_colors = false;
};

}  // namespace

std::size_t length_of_off_keyword(std::string_view text)
{
  std::size_t length = 0;
  for (const std::string_view part : {"ST", "C", "N", "4", "n"})
    if (starts_with(text.substr(length), part)) length += part.size();
  return starts_with(text.substr(length), "OFF") ? length + 3 : 0;
}

Surface_file parse_off(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  return Off_reader(checked_bytes(bytes, path), path, bad_faces).take();
}

Surface_file read_off(const std::string& path)
{
  return parse_off(read_bytes(path), path);
}

}  // namespace conformal
