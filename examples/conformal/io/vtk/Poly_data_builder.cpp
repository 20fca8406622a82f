// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Poly_data_builder.h"

#include "conformal/io/file/io_errors.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace conformal {

std::string vtk_name(std::string_view word)
{
  std::string name;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const bool is_code = word[i] == '%' && i + 2 < word.size();
    name += is_code ? static_cast<char>(
                          std::strtol(std::string(word.substr(i + 1, 2)).c_str(), nullptr, 16))
                    : word[i];
    if (is_code) i += 2;
  }
  return name;
}

Poly_data_builder::Poly_data_builder(const std::string& path, File_format format,
                                     Bad_faces bad_faces)
    : m_bad_faces(bad_faces)
{
  m_file.path = path;
  m_file.format = format;
}

void Poly_data_builder::set_points(const std::vector<double>& coordinates, std::size_t line)
{
  if (!m_file.points.empty()) throw Read_error(m_file.path, line, "has points twice");
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    m_file.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    for (const double x : m_file.points.back())
      if (!std::isfinite(x))
        throw Read_error(m_file.path, line,
                         "a coordinate of point " + std::to_string(i / 3) + " is not finite");
  }
  m_file.vertices.size = m_file.points.size();
}

void Poly_data_builder::set_faces(const std::vector<double>& first,
                                  const std::vector<double>& corners, std::size_t line)
{
  for (std::size_t f = 0; f + 1 < first.size(); ++f) {
    const bool is_row = first[f] >= 0 && first[f] <= first[f + 1] &&
                        first[f + 1] <= static_cast<double>(corners.size());
    const std::string name = "polygon " + std::to_string(f) + ": ";
    if (!is_row) throw Read_error(m_file.path, line, name + "its corners are not in the table");
    std::vector<std::int64_t> row;
    for (auto c = static_cast<std::size_t>(first[f]); c < static_cast<std::size_t>(first[f + 1]);
         ++c)
      row.push_back(std::abs(corners[c]) < 1e18 ? static_cast<std::int64_t>(corners[c]) : -1);
    const auto* const begin = row.data();
    const std::string fault =
        fault_of_face(begin, begin + row.size(), m_file.points.size(), 0, m_bad_faces);
    if (!fault.empty()) throw Read_error(m_file.path, line, name + fault);
    append_face(m_file.polygons, begin, begin + row.size());
  }
  m_file.faces.size = m_file.polygons.size();
}

void Poly_data_builder::add_array(bool is_at_points, Vtk_array array)
{
  (is_at_points ? m_at_points : m_at_cells).push_back(std::move(array));
}

Surface_file Poly_data_builder::take()
{
  if (m_file.polygons.size() == 0)
    throw Read_error(m_file.path, 0, "no polygons, wanted a surface");
  set_arrays(m_file.vertices, std::move(m_at_points), 0, m_left_out);
  set_arrays(m_file.faces, std::move(m_at_cells), m_skipped, m_left_out);
  m_file.notes = m_left_out.notes();
  return std::move(m_file);
}

}  // namespace conformal
