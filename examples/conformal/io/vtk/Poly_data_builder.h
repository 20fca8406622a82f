// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Poly_data.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// a name of a legacy file, where % and two digits are a byte
std::string vtk_name(std::string_view word);

/// Puts a surface together from the tables of a VTK file.
class Poly_data_builder {
 public:
  Poly_data_builder(const std::string& path, File_format format, Bad_faces bad_faces);

  /// \param line of the first point, for messages \throws Read_error
  void set_points(const std::vector<double>& coordinates, std::size_t line);

  /// \param first where each polygon begins in the corners, and where the last one ends
  void set_faces(const std::vector<double>& first, const std::vector<double>& corners,
                 std::size_t line);

  /// cells without an area, whose rows come before those of polygons
  void skip_cells(std::size_t count) { m_skipped += count; }

  void add_array(bool is_at_points, Vtk_array array);
  void leave_out(const std::string& what) { m_left_out.add(what, ""); }

  Surface_file take();

 private:
  Surface_file m_file;
  Bad_faces m_bad_faces;
  Left_out m_left_out;
  std::size_t m_skipped = 0;
  std::vector<Vtk_array> m_at_points, m_at_cells;
};

}  // namespace conformal
