// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_curve_rows.h"

#include "conformal/io/file/Text_scanner.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/number_rows.h"
#include "conformal/io/file/numbers.h"

#include <cctype>
#include <numeric>

namespace conformal {
namespace {

bool has_heading(std::string_view bytes)
{
  const std::string_view line = bytes.substr(0, bytes.find('\n'));
  const std::string_view word = line.substr(0, line.find_first_of(" \t\r,;"));
  return !word.empty() && (std::isalpha(static_cast<unsigned char>(word[0])) || word[0] == '"') &&
         !parse_double(word);
}

Eigen::Vector2d point_of(const Number_row& row, const std::string& path)
{
  if (row.numbers.size() != 2)
    throw Read_error(
        path, row.line,
        std::to_string(row.numbers.size()) + " numbers, wanted the x and y of a point");
  const Eigen::Vector2d p(row.numbers[0], row.numbers[1]);
  if (!p.allFinite()) throw Read_error(path, row.line, "a coordinate that is not finite");
  return p;
}

void finish(std::vector<Eigen::Vector2d>& points, std::vector<Plane_curve>& curves)
{
  if (points.empty()) return;
  curves.push_back({"curve " + std::to_string(curves.size()), columns(points), false});
  points.clear();
}

class Obj_lines {
 public:
  Obj_lines(std::string_view bytes, const std::string& path)
      : m_scanner(bytes, path, Text_scanner::hash_comments | Text_scanner::backslash_continues_line)
  {
    while (!m_scanner.at_end()) {
      const std::string_view word = m_scanner.word("a line");
      if (word == "v") read_vertex();
      if (word == "l") read_line();
      m_scanner.rest_of_line();
    }
    if (m_lines.empty() && !m_points.empty()) {
      m_lines.emplace_back(m_points.size());
      std::iota(m_lines.back().begin(), m_lines.back().end(), 0);
    }
  }

  std::vector<Plane_curve> curves() const
  {
    std::vector<Plane_curve> curves;
    for (const auto& line : m_lines) {
      std::vector<Eigen::Vector2d> points;
      for (const auto i : line) points.push_back(m_points[static_cast<std::size_t>(i)]);
      finish(points, curves);
      curves.back().is_closed = line.size() > 1 && line.front() == line.back();
    }
    return curves;
  }

 private:
  void read_vertex()
  {
    const double x = m_scanner.line_coordinate("x");
    const double y = m_scanner.line_coordinate("y");
    if (m_scanner.line_coordinate("z") != 0) m_scanner.fail("a vertex with z, wanted z = 0");
    m_points.emplace_back(x, y);
  }

  void read_line()
  {
    const auto n = static_cast<std::int64_t>(m_points.size());
    auto& line = m_lines.emplace_back();
    while (!m_scanner.at_end_of_line()) {
      std::string_view word = m_scanner.word("");
      word = word.substr(0, word.find('/'));  // v/vt
      const auto index = parse_integer(word);
      if (!index || *index == 0 || *index > n || *index < -n)
        m_scanner.fail(in_quotes(word) + " is not the index of a vertex, wanted 1 to " +
                       std::to_string(n));
      line.push_back(*index < 0 ? n + *index : *index - 1);
    }
    if (line.empty()) m_scanner.fail("a line without vertices");
  }

  Text_scanner m_scanner;
  std::vector<Eigen::Vector2d> m_points;
  std::vector<std::vector<std::int64_t>> m_lines;
};

}  // namespace

std::vector<Plane_curve> parse_curve_rows(std::string_view bytes, const std::string& path)
{
  std::string text;
  if (has_heading(bytes)) {
    text = "#" + std::string(bytes);
    bytes = text;
  }
  std::vector<Plane_curve> curves;
  std::vector<Eigen::Vector2d> points;
  for (const Number_row& row : number_rows(bytes, path)) {
    if (!row.numbers.empty())
      points.push_back(point_of(row, path));
    else if (!row.has_comment)
      finish(points, curves);
  }
  finish(points, curves);
  return curves;
}

std::vector<Plane_curve> parse_obj_lines(std::string_view bytes, const std::string& path)
{
  return Obj_lines(bytes, path).curves();
}

}  // namespace conformal
