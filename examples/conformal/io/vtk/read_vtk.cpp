// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_vtk.h"

#include "Poly_data.h"
#include "Poly_data_builder.h"

#include "conformal/io/file/checked_bytes.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace conformal {
namespace {

/// Words, lines and tables of numbers, which may be binary
class Vtk_reader {
 public:
  Vtk_reader(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
      : m_text(bytes), m_path(path), m_data(path, File_format::vtk, bad_faces)
  {
    line();  // # vtk DataFile Version 5.1
    line();  // a title
    m_is_binary = lower(word("ASCII or BINARY")) == "binary";
    if (lower(word("DATASET")) != "dataset" || lower(word("POLYDATA")) != "polydata")
      fail("holds another dataset than POLYDATA, which is wanted");
    while (!at_end()) read_block(lower(word("a keyword")));
  }

  Surface_file take() { return m_data.take(); }

 private:
  [[noreturn]] void fail(const std::string& message) const
  {
    throw Read_error(m_path, m_line, message);
  }

  void advance(std::size_t size)
  {
    m_line += static_cast<std::size_t>(
        std::count(m_text.begin(), m_text.begin() + static_cast<std::ptrdiff_t>(size), '\n'));
    m_text.remove_prefix(size);
  }

  std::string_view line()
  {
    const std::string_view found = m_text.substr(0, m_text.find('\n'));
    advance(std::min(found.size() + 1, m_text.size()));
    return found;
  }

  bool at_end()
  {
    advance(std::min(m_text.find_first_not_of(" \t\r\n"), m_text.size()));
    return m_text.empty();
  }

  std::string_view word(const std::string& wanted)
  {
    if (at_end()) fail("ends before " + wanted);
    const std::string_view found = m_text.substr(0, m_text.find_first_of(" \t\r\n"));
    advance(found.size());
    return found;
  }

  std::size_t count(const std::string& wanted)
  {
    const std::string_view found = word(wanted);
    const auto number = parse_integer(found);
    if (!number || *number < 0 || static_cast<std::uint64_t>(*number) > m_bytes_at_most)
      fail(in_quotes(found) + " is not " + wanted);
    return static_cast<std::size_t>(*number);
  }

  const Vtk_type* type()
  {
    const std::string_view name = word("a type");
    const Vtk_type* found = vtk_type(lower(name));
    if (found == nullptr && name == "vtkIdType") found = vtk_type(name);
    if (found == nullptr) fail(in_quotes(name) + " is not a type of numbers that is read");
    return found;
  }

  /// A table; the line end before binary numbers is the last one.
  std::vector<double> numbers(const Vtk_type& type, std::size_t count)
  {
    return m_is_binary ? binary_numbers(type, count) : text_numbers(count);
  }

  std::vector<double> text_numbers(std::size_t count)
  {
    std::vector<double> values;
    while (values.size() < count) {
      const std::string_view found = word("the last of " + std::to_string(count) + " numbers");
      const auto number = parse_double(found);
      if (!number) fail(in_quotes(found) + " is not a number");
      values.push_back(*number);
    }
    return values;
  }

  std::vector<double> binary_numbers(const Vtk_type& type, std::size_t count)
  {
    line();
    if (count > m_text.size() / type.size)
      fail("ends before the last of " + std::to_string(count) + " numbers");
    std::vector<double> values;
    std::string number(type.size, '\0');
    for (std::size_t i = 0; i < count; ++i) {
      std::copy_n(m_text.data() + i * type.size, type.size, number.rbegin());  // big endian
      values.push_back(type.read(number.data()));
    }
    m_text.remove_prefix(count * type.size);
    return values;
  }

  void read_block(const std::string& keyword)
  {
    if (keyword == "points")
      read_points();
    else if (keyword == "polygons")
      read_cells(true);
    else if (keyword == "vertices" || keyword == "lines" || keyword == "triangle_strips")
      read_other_cells(keyword);
    else if (keyword == "point_data" || keyword == "cell_data")
      m_is_at_points = keyword == "point_data", m_rows = count("a number of rows");
    else if (keyword == "metadata")
      skip_metadata();
    else
      read_array(keyword);
  }

  /// up to an empty line
  void skip_metadata()
  {
    line();
    while (!m_text.empty() && line().find_first_not_of(" \r") != std::string_view::npos) {
    }
  }

  void read_points()
  {
    const std::size_t size = count("a number of points");
    const Vtk_type* const numbers_of = type();
    const std::size_t first_line = m_line + 1;
    m_data.set_points(numbers(*numbers_of, 3 * size), first_line);
  }

  /// Up to version 4: the number of corners of each cell and these; since version 5: where each
  /// begins, and all corners
  void read_cells(bool is_kept)
  {
    const std::size_t cells = count("a number of polygons"), size = count("a number of corners");
    std::vector<double> first, corners;
    const std::string_view rest = m_text;
    const std::size_t line_before = m_line;
    if (lower(m_is_binary ? after_line_end() : word("corners")) == "offsets") {
      if (m_is_binary) word("OFFSETS");
      const Vtk_type* const of_first = type();
      first = numbers(*of_first, cells);
      if (lower(word("CONNECTIVITY")) != "connectivity") fail("CONNECTIVITY is missing");
      const Vtk_type* const of_corners = type();
      corners = numbers(*of_corners, size);
    } else {
      m_text = rest;
      m_line = line_before;
      split(numbers(*vtk_type("int"), size), cells, first, corners);
    }
    if (is_kept) m_data.set_faces(first, corners, line_before);
  }

  /// the word behind the end of this line, which is not taken
  std::string_view after_line_end() const
  {
    const std::string_view next = m_text.substr(std::min(m_text.find('\n') + 1, m_text.size()));
    return next.substr(0, next.find_first_of(" \n"));
  }

  void split(const std::vector<double>& table, std::size_t cells, std::vector<double>& first,
             std::vector<double>& corners) const
  {
    first = {0};
    for (std::size_t i = 0; i < table.size();) {
      const double degree = table[i];
      if (!(degree >= 0 && degree < static_cast<double>(table.size() - i)))
        fail("polygon " + std::to_string(first.size() - 1) + " has more corners than the table");
      const auto begin = table.begin() + static_cast<std::ptrdiff_t>(i) + 1;
      corners.insert(corners.end(), begin, begin + static_cast<std::ptrdiff_t>(degree));
      first.push_back(static_cast<double>(corners.size()));
      i += static_cast<std::size_t>(degree) + 1;
    }
    if (first.size() != cells + 1)
      fail("has " + std::to_string(first.size() - 1) + " polygons, not " + std::to_string(cells));
  }

  void read_other_cells(const std::string& keyword)
  {
    const std::string_view size = m_text;
    const std::string_view cells_word = word("a number of cells");
    const auto cells = parse_integer(cells_word);
    m_text = size;
    m_data.leave_out(keyword);
    read_cells(false);
    if (keyword != "triangle_strips" && cells) m_data.skip_cells(static_cast<std::size_t>(*cells));
  }

  void read_array(const std::string& keyword)
  {
    if (keyword == "field") return read_field();
    if (keyword == "lookup_table") {
      word("a name");
      return void(numbers(*vtk_type("unsigned_char"), 4 * count("a number of colours")));
    }
    Vtk_array array{vtk_name(word("the name of an array"))};
    if (keyword == "scalars") {
      array.type = type();
      read_scalars(array);
    } else if (keyword == "color_scalars") {
      read_colors(array);
    } else {
      if (keyword == "normals") array.name = "Normals";
      if (keyword == "texture_coordinates") array.name = "TCoords";
      const bool is_triple = keyword == "normals" || keyword == "vectors";
      const bool is_single = keyword == "global_ids" || keyword == "pedigree_ids";
      if (is_triple || is_single || keyword == "tensors")
        array.width = is_triple ? 3 : is_single ? 1 : 9;
      else if (keyword == "texture_coordinates")
        array.width = count("a width");
      else
        fail(in_quotes(keyword) + " is not a keyword of VTK");
      array.type = type();
      array.values = numbers(*array.type, m_rows * array.width);
    }
    m_data.add_array(m_is_at_points, std::move(array));
  }

  void read_scalars(Vtk_array& array)
  {
    const std::string_view rest = m_text.substr(0, m_text.find('\n'));
    if (rest.find_first_of("123456789") != rest.npos) array.width = count("a width");
    if (lower(word("LOOKUP_TABLE")) != "lookup_table") fail("LOOKUP_TABLE is missing");
    word("the name of a table");
    array.values = numbers(*array.type, m_rows * array.width);
  }

  // bytes, or numbers from 0 to 1 in a text
  void read_colors(Vtk_array& array)
  {
    array.width = count("a width");
    array.type = vtk_type("unsigned_char");
    array.values = numbers(*array.type, m_rows * array.width);
    for (double& value : array.values)
      if (!m_is_binary) value = std::round(std::clamp(255 * value, 0., 255.));
  }

  void read_field()
  {
    word("the name of a field");
    for (std::size_t arrays = count("a number of arrays"); arrays > 0; --arrays) {
      Vtk_array array{vtk_name(word("the name of an array"))};
      if (array.name == "METADATA") {
        skip_metadata();
        array.name = vtk_name(word("the name of an array"));
      }
      array.width = count("a width");
      const std::size_t rows = count("a number of rows");
      array.type = type();
      array.values = numbers(*array.type, array.width * rows);
      if (m_rows > 0 && array.width > 0) m_data.add_array(m_is_at_points, std::move(array));
    }
  }

  std::string_view m_text;
  std::string m_path;
  std::size_t m_line = 1;
  std::uint64_t m_bytes_at_most = m_text.size();
  bool m_is_binary = false, m_is_at_points = true;
  std::size_t m_rows = 0;
  Poly_data_builder m_data;
};

}  // namespace

Surface_file parse_vtk(std::string_view bytes, const std::string& path, Bad_faces bad_faces)
{
  return Vtk_reader(bytes, path, bad_faces).take();
}

}  // namespace conformal
