// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_vtk.h"

#include "Poly_data.h"

#include "conformal/io/file/little_endian.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace conformal {
namespace {

template <class Number>
void append_big_endian(std::string& bytes, Number number)
{
  append_little_endian(bytes, number);
  std::reverse(bytes.end() - static_cast<std::ptrdiff_t>(sizeof number), bytes.end());
}

/// a word of a legacy file
std::string coded(const std::string& name)
{
  std::string word;
  for (const char c : name) {
    std::array<char, 4> code{};
    std::snprintf(code.data(), code.size(), "%%%02X", static_cast<unsigned>(c & 0xff));
    word += c > ' ' && c <= '~' && c != '%' && c != '"' ? std::string(1, c) : code.data();
  }
  return word;
}

void append_numbers(std::string& bytes, const Vtk_array& array)
{
  for (const double value : array.values) {
    array.type->append(bytes, value);
    std::reverse(bytes.end() - static_cast<std::ptrdiff_t>(array.type->size), bytes.end());
  }
  bytes += '\n';
}

void append_arrays(std::string& bytes, const char* where, const Element& element)
{
  std::vector<Vtk_array> arrays = arrays_of(element);
  if (arrays.empty()) return;
  const std::string rows = std::to_string(element.size);
  bytes += where + (' ' + rows) + '\n';
  for (const Vtk_array& array : arrays) {
    const std::string type(array.type->legacy);
    if (array.name == "Normals")
      bytes += "NORMALS Normals " + type + '\n';
    else if (array.name == "TCoords")
      bytes += "TEXTURE_COORDINATES TCoords 2 " + type + '\n';
    else
      bytes += "FIELD FieldData 1\n" + coded(array.name) + ' ' + std::to_string(array.width) + ' ' +
               rows + ' ' + type + '\n';
    append_numbers(bytes, array);
  }
}

}  // namespace

std::string encode_vtk(const Surface_file& file, std::vector<std::string>& notes)
{
  const Polygons& polygons = file.polygons;
  std::string bytes =
      "# vtk DataFile Version 3.0\nwritten by conformal\nBINARY\nDATASET POLYDATA\n";
  bytes += "POINTS " + std::to_string(file.points.size()) + " double\n";
  for (const Point& point : file.points)
    for (const double x : point) append_big_endian(bytes, x);
  bytes += "\nPOLYGONS " + std::to_string(polygons.size()) + ' ' +
           std::to_string(polygons.size() + polygons.corners.size()) + '\n';
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    append_big_endian(bytes, static_cast<std::int32_t>(polygons.degree(f)));
    for (std::size_t c = polygons.first[f]; c < polygons.first[f + 1]; ++c)
      append_big_endian(bytes, std::int32_t{polygons.corners[c]});
  }
  bytes += '\n';
  append_arrays(bytes, "POINT_DATA", vtk_vertices(file));
  append_arrays(bytes, "CELL_DATA", file.faces);
  note_vtk_losses(file, notes);
  return bytes;
}

}  // namespace conformal
