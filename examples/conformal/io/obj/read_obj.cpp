// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_obj.h"

#include "conformal/io/data/Left_out.h"
#include "conformal/io/file/Text_scanner.h"
#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/numbers.h"
#include "conformal/io/file/read_bytes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace conformal {
namespace {

using namespace std::string_view_literals;

// Lines that go back into an OBJ file where they were.
constexpr std::array kept_words = {"g"sv,      "o"sv,      "s"sv,      "mg"sv,
                                   "mtllib"sv, "usemtl"sv, "maplib"sv, "usemap"sv};

bool is_kept(std::string_view word)
{
  return std::find(kept_words.begin(), kept_words.end(), word) != kept_words.end();
}

class Obj_reader {
 public:
  Obj_reader(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
      : m_scanner(bytes, path,
                  Text_scanner::hash_comments | Text_scanner::backslash_continues_line),
        m_bad_faces(bad_faces)
  {
    m_file.path = path;
    m_file.format = File_format::obj;
    while (next_line()) read_line(m_scanner.word("a line"));
    check_faces();
    check_indices(m_texture, m_file.texture, "texture indices without coordinates");
    check_indices(m_normals, m_file.normals, "normal indices without a normal");
    store();
  }

  Surface_file take() { return std::move(m_file); }

 private:
  // On to the next line with a word; comments on the way are kept.
  bool next_line()
  {
    std::string_view comment;
    while (m_scanner.skip_to_word(comment)) {
      if (comment.empty()) return true;
      m_file.comments.emplace_back(comment.substr(comment.size() > 1 && comment[1] == ' ' ? 2 : 1));
    }
    return false;
  }

  void read_line(std::string_view word)
  {
    if (word == "v")
      read_vertex();
    else if (word == "f" || word == "fo")  // `fo` was the word for faces up to version 2
      read_face();
    else if (word == "vt")
      read_row(m_file.texture, 1, "values after texture coordinates");
    else if (word == "vn")
      read_row(m_file.normals, 3, "values after normals");
    else if (is_kept(word))
      keep(word);
    else
      leave_out_line(in_quotes(word) + " statements");
  }

  void leave_out(std::string_view what) { leave_out(what, m_scanner.line()); }
  void leave_out(std::string_view what, std::size_t line)
  {
    m_left_out.add(what, "line " + std::to_string(line));
  }

  void leave_out_line(std::string_view what)
  {
    leave_out(what);
    while (!m_scanner.at_end_of_line()) m_scanner.word("");
  }

  // The numbers on the rest of the line, N at most; what follows them is left out.
  template <std::size_t N>
  std::size_t read_values(std::array<double, N>& values, const char* surplus)
  {
    std::size_t count = 0;
    while (!m_scanner.at_end_of_line()) {
      const std::optional<double> value = parse_double(m_scanner.word(""));
      if (!value || count == N) {
        leave_out_line(surplus);
        break;
      }
      values[count++] = *value;
    }
    return count;
  }

  void keep(std::string_view word)
  {
    std::string text(word);
    const std::string_view rest = m_scanner.rest_of_line();
    if (!rest.empty()) text.append(1, ' ').append(rest);
    m_file.group_lines.push_back({m_file.polygons.size(), std::move(text)});
  }

  // x y z, perhaps a weight (of the points of curves) or r g b [a]
  void read_vertex()
  {
    Point point;
    for (double& x : point) x = m_scanner.line_coordinate("a coordinate");
    const char* const no_colors = "values of vertices that are not colours";
    std::array<double, 4> extra{};
    std::size_t count = read_values(extra, no_colors);
    if (count == 2 || (count == 1 && extra[0] != 1)) leave_out(no_colors);
    if (count < 3) count = 0;
    if (m_file.points.empty()) m_colors_per_vertex = count;
    if (count != m_colors_per_vertex && !std::exchange(m_has_mixed_colors, true))
      leave_out("colours, which not all vertices have");
    m_file.points.push_back(point);
    m_colors.insert(m_colors.end(), extra.begin(),
                    extra.begin() + static_cast<std::ptrdiff_t>(count));
    if (m_file.points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      m_scanner.fail("more than 2147483647 vertices, the limit");
  }

  // A row stays in the table even if it is left out, since the indices count it: as not a number.
  void read_row(Corner_values& table, std::size_t least, const char* surplus)
  {
    std::array<double, 3> row{};
    const std::size_t count = read_values(row, surplus);
    if (count < least) row[0] = std::numeric_limits<double>::quiet_NaN();
    table.dimension = std::max(table.dimension, count);
    table.values.push_back(row);
  }

  // Takes one of v/vt/vn from a corner.
  static std::string_view take_part(std::string_view& corner)
  {
    const std::string_view part = corner.substr(0, corner.find('/'));
    corner.remove_prefix(std::min(part.size() + 1, corner.size()));
    return part;
  }

  // From 0; it may be that of a row that follows.
  static std::optional<std::int64_t> index_of(std::string_view text, std::size_t so_far)
  {
    const auto index = parse_integer(text);
    const auto n = static_cast<std::int64_t>(so_far);
    if (!index || *index == 0 || *index < -n || *index > std::numeric_limits<int>::max()) return {};
    return *index < 0 ? n + *index : *index - 1;
  }

  std::int64_t take_vertex(std::string_view& corner)
  {
    const std::string_view text = take_part(corner);
    const std::size_t n = m_file.points.size();
    if (const auto index = index_of(text, n)) return *index;
    if (!parse_integer(text))
      m_scanner.fail(in_quotes(text) + " is not an index, wanted v, v/vt, v//vn or v/vt/vn");
    m_scanner.fail("the index " + std::string(text) + ", wanted 1 to 2147483647" +
                   (n == 0 ? "" : ", or -" + std::to_string(n) + " to -1"));
  }

  // -1 for none
  int take_row(std::string_view& corner, const Corner_values& table)
  {
    const std::string_view text = take_part(corner);
    if (text.empty()) return -1;
    const auto index = index_of(text, table.values.size());
    if (!index) leave_out("indices of corners that are none");
    return static_cast<int>(index.value_or(-1));
  }

  void read_face()
  {
    m_lines.push_back(m_scanner.line());
    m_corners.clear();
    while (!m_scanner.at_end_of_line()) {
      std::string_view corner = m_scanner.word("");
      m_corners.push_back(take_vertex(corner));
      m_texture.push_back(take_row(corner, m_file.texture));
      m_normals.push_back(take_row(corner, m_file.normals));
      if (!corner.empty()) leave_out("further indices of corners");
    }
    append_face(m_file.polygons, m_corners.data(), m_corners.data() + m_corners.size());
  }

  // Faces may stand before their vertices, so this comes last.
  void check_faces()
  {
    if (m_file.points.empty()) {
      const auto notes = m_left_out.notes();
      m_scanner.fail("no vertices, wanted a surface" + (notes.empty() ? "" : "; " + notes[0]));
    }
    if (m_file.polygons.size() == 0) m_scanner.fail("no faces, wanted a surface");
    for (std::size_t f = 0; f < m_file.polygons.size(); ++f) {
      const auto begin = static_cast<std::ptrdiff_t>(m_file.polygons.first[f]);
      const auto end = static_cast<std::ptrdiff_t>(m_file.polygons.first[f + 1]);
      const auto& corners = m_file.polygons.corners;
      m_corners.assign(corners.begin() + begin, corners.begin() + end);
      const std::string fault = fault_of_face(m_corners.data(), m_corners.data() + m_corners.size(),
                                              m_file.points.size(), 1, m_bad_faces);
      if (!fault.empty()) m_scanner.fail_at(m_lines[f], fault);
    }
  }

  // Leaves out indices of rows that are not there, or that are left out.
  void check_indices(std::vector<int>& indices, const Corner_values& table, const char* what)
  {
    const auto is_there = [&table](int index) {
      const auto row = static_cast<std::size_t>(index);
      return row < table.values.size() && !std::isnan(table.values[row][0]);
    };
    for (std::size_t f = 0; f < m_file.polygons.size(); ++f)
      for (std::size_t i = m_file.polygons.first[f]; i < m_file.polygons.first[f + 1]; ++i)
        if (indices[i] >= 0 && !is_there(indices[i])) {
          indices[i] = -1;
          leave_out(what, m_lines[f]);
        }
  }

  void store()
  {
    m_file.vertices.size = m_file.points.size();
    m_file.faces.size = m_file.polygons.size();
    m_file.notes = m_left_out.notes();
    std::vector<std::string> names = {"red", "green", "blue", "alpha"};
    names.resize(m_has_mixed_colors ? 0 : m_colors_per_vertex);
    set_properties(m_file.vertices, names, Value_type::float64, m_colors);
    const auto is_given = [](int index) { return index >= 0; };
    if (std::any_of(m_texture.begin(), m_texture.end(), is_given))
      m_file.texture.index = std::move(m_texture);
    if (std::any_of(m_normals.begin(), m_normals.end(), is_given))
      m_file.normals.index = std::move(m_normals);
    m_file.normals.dimension = 3;
  }

  Surface_file m_file;
  Text_scanner m_scanner;
  Bad_faces m_bad_faces;
  Left_out m_left_out;
  std::vector<double> m_colors;
  std::size_t m_colors_per_vertex = 0;
  bool m_has_mixed_colors = false;
  std::vector<std::int64_t> m_corners;    // of one face
  std::vector<int> m_texture, m_normals;  // per corner
  std::vector<std::size_t> m_lines;       // of the faces
};

}  // namespace

Surface_file parse_obj(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  return Obj_reader(checked_bytes(bytes, path), path, bad_faces).take();
}

Surface_file read_obj(const std::string& path)
{
  return parse_obj(read_bytes(path), path);
}

}  // namespace conformal
