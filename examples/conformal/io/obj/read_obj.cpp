// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_obj.h"

#include "conformal/io/file/Text_scanner.h"
#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/numbers.h"
#include "conformal/io/file/read_bytes.h"

#include <algorithm>
#include <limits>

namespace conformal {
namespace {

using namespace std::string_view_literals;

// Lines that go back into an OBJ file where they were.
constexpr std::array kept_words = {"g"sv,      "o"sv,      "s"sv,      "mg"sv,
                                   "mtllib"sv, "usemtl"sv, "maplib"sv, "usemap"sv};

// Lines that say nothing about a polygon mesh.
constexpr std::array skipped_words = {
    "p"sv,        "l"sv,        "vp"sv,         "deg"sv,       "bmat"sv, "step"sv,  "cstype"sv,
    "curv"sv,     "curv2"sv,    "surf"sv,       "parm"sv,      "trim"sv, "hole"sv,  "scrv"sv,
    "sp"sv,       "end"sv,      "con"sv,        "bevel"sv,     "lod"sv,  "ctech"sv, "stech"sv,
    "c_interp"sv, "d_interp"sv, "shadow_obj"sv, "trace_obj"sv, "call"sv, "csh"sv};

template <class Words>
bool is_one_of(std::string_view word, const Words& words)
{
  return std::find(words.begin(), words.end(), word) != words.end();
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
      read_texture();
    else if (word == "vn")
      read_normal();
    else if (is_one_of(word, kept_words))
      keep(word);
    else if (is_one_of(word, skipped_words))
      while (!m_scanner.at_end_of_line()) m_scanner.word("");
    else
      m_scanner.fail(in_quotes(word) + " is no word of an OBJ file, wanted v, vt, vn, f, ...");
  }

  void end_line(const char* what)
  {
    if (!m_scanner.at_end_of_line())
      m_scanner.fail(in_quotes(m_scanner.word("")) + " after " + what + ", wanted a new line");
  }

  void keep(std::string_view word)
  {
    std::string text(word);
    const std::string_view rest = m_scanner.rest_of_line();
    if (!rest.empty()) text.append(1, ' ').append(rest);
    m_file.group_lines.push_back({m_file.polygons.size(), std::move(text)});
  }

  // x y z, x y z w, x y z r g b or x y z r g b a
  void read_vertex()
  {
    Point point;
    for (double& x : point) x = m_scanner.line_coordinate("a coordinate");
    std::array<double, 4> extra{};
    std::size_t count = 0;
    for (; count < extra.size() && !m_scanner.at_end_of_line(); ++count)
      extra[count] = m_scanner.number("a colour");
    end_line("a vertex");
    if (count == 1 && extra[0] == 1.0) count = 0;  // the weight of a rational curve's point
    if (count != 0 && count < 3)
      m_scanner.fail("a vertex with " + std::to_string(3 + count) + " numbers, wanted 3, 6 or 7");
    if (m_file.points.empty()) m_colors_per_vertex = count;
    if (count != m_colors_per_vertex)
      m_scanner.fail("a vertex with " + std::to_string(count) + " numbers for its colour, wanted " +
                     std::to_string(m_colors_per_vertex) + " as before");
    m_file.points.push_back(point);
    m_colors.insert(m_colors.end(), extra.begin(),
                    extra.begin() + static_cast<std::ptrdiff_t>(count));
    if (m_file.points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      m_scanner.fail("more than 2147483647 vertices, the limit");
  }

  void read_texture()
  {
    std::array<double, 3> row{};
    std::size_t count = 0;
    for (; count < 3 && !m_scanner.at_end_of_line(); ++count)
      row[count] = m_scanner.number("a texture coordinate");
    if (count == 0) m_scanner.fail("vt without numbers, wanted texture coordinates");
    end_line("texture coordinates");
    m_file.texture.dimension = std::max(m_file.texture.dimension, count);
    m_file.texture.values.push_back(row);
  }

  void read_normal()
  {
    std::array<double, 3> row{};
    for (double& x : row) {
      if (m_scanner.at_end_of_line()) m_scanner.fail("vn with too few numbers, wanted three");
      x = m_scanner.number("a normal");
    }
    end_line("a normal");
    m_file.normals.values.push_back(row);
  }

  // One of the indices of v/vt/vn, from 0; nothing (-1) where it is left out. Takes it from `word`.
  std::int64_t take_index(std::string_view& word, std::size_t so_far, bool is_needed)
  {
    const std::size_t end = std::min(word.find('/'), word.size());
    const std::string_view text = word.substr(0, end);
    word.remove_prefix(std::min(end + 1, word.size()));
    if (text.empty() && !is_needed) return -1;
    const auto index = parse_integer(text);
    if (!index)
      m_scanner.fail(in_quotes(text) + " is not an index, wanted v, v/vt, v//vn or v/vt/vn");
    const auto n = static_cast<std::int64_t>(so_far);
    if (*index == 0) m_scanner.fail("the index 0, wanted 1 or more, or a negative one");
    if (*index < -n)
      m_scanner.fail("the relative index " + std::to_string(*index) + ", but only " +
                     std::to_string(n) + " stand before it");
    if (*index > std::numeric_limits<int>::max())
      m_scanner.fail("the index " + std::to_string(*index) + " is above 2147483647, the limit");
    return *index < 0 ? n + *index : *index - 1;
  }

  void read_face()
  {
    m_lines.push_back(m_scanner.line());
    m_corners.clear();
    while (!m_scanner.at_end_of_line()) {
      std::string_view word = m_scanner.word("");
      m_corners.push_back(take_index(word, m_file.points.size(), true));
      m_texture.push_back(static_cast<int>(take_index(word, m_file.texture.values.size(), false)));
      m_normals.push_back(static_cast<int>(take_index(word, m_file.normals.values.size(), false)));
      if (!word.empty()) m_scanner.fail("a corner of more than three indices, wanted v/vt/vn");
    }
    append_face(m_file.polygons, m_corners.data(), m_corners.data() + m_corners.size());
  }

  // Faces may stand before their vertices, so this comes last.
  void check_faces()
  {
    if (m_file.points.empty()) m_scanner.fail("no vertices, wanted a surface");
    if (m_file.polygons.size() == 0) m_scanner.fail("no faces, wanted a surface");
    for (std::size_t f = 0; f < m_file.polygons.size(); ++f) {
      const auto begin = static_cast<std::ptrdiff_t>(m_file.polygons.first[f]);
      const auto end = static_cast<std::ptrdiff_t>(m_file.polygons.first[f + 1]);
      const auto& corners = m_file.polygons.corners;
      m_corners.assign(corners.begin() + begin, corners.begin() + end);
      const std::string fault = fault_of_face(m_corners.data(), m_corners.data() + m_corners.size(),
                                              m_file.points.size(), 1, m_bad_faces);
      if (!fault.empty()) m_scanner.fail_at(m_lines[f], fault);
      check_indices(f, m_texture, m_file.texture.values.size(), "texture");
      check_indices(f, m_normals, m_file.normals.values.size(), "normal");
    }
  }

  void check_indices(std::size_t f, const std::vector<int>& indices, std::size_t n,
                     const char* name) const
  {
    for (std::size_t i = m_file.polygons.first[f]; i < m_file.polygons.first[f + 1]; ++i)
      if (indices[i] >= static_cast<std::int64_t>(n))
        m_scanner.fail_at(m_lines[f], std::string("a face has the ") + name + " index " +
                                          std::to_string(std::int64_t{indices[i]} + 1) +
                                          ", wanted 1 to " + std::to_string(n));
  }

  void store()
  {
    m_file.vertices.size = m_file.points.size();
    m_file.faces.size = m_file.polygons.size();
    std::vector<std::string> names = {"red", "green", "blue", "alpha"};
    names.resize(m_colors_per_vertex);
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
  std::vector<double> m_colors;
  std::size_t m_colors_per_vertex = 0;
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
