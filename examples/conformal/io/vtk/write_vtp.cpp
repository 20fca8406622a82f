// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_vtp.h"

#include "Poly_data.h"

#include "conformal/io/file/base64.h"
#include "conformal/io/file/little_endian.h"

#include <cstdint>

namespace conformal {
namespace {

std::string escaped(const std::string& name)
{
  std::string text;
  for (const char c : name)
    text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '"' ? "&quot;" : std::string(1, c);
  return text;
}

void append_array(std::string& text, const Vtk_array& array)
{
  std::string numbers, bytes;
  for (const double value : array.values) array.type->append(numbers, value);
  append_little_endian(bytes, static_cast<std::uint64_t>(numbers.size()));
  text += "<DataArray type=\"" + std::string(array.type->xml) + "\" Name=\"" + escaped(array.name) +
          "\" NumberOfComponents=\"" + std::to_string(array.width) + "\" format=\"binary\">" +
          base64(bytes += numbers) + "</DataArray>\n";
}

void append_data(std::string& text, const std::string& tag, const Element& element)
{
  const std::vector<Vtk_array> arrays = arrays_of(element);
  std::string roles;
  for (const Vtk_array& array : arrays)
    if (array.name == "Normals" || array.name == "TCoords")
      roles += ' ' + array.name + "=\"" + array.name + '"';
  text += '<' + tag + roles + ">\n";
  for (const Vtk_array& array : arrays) append_array(text, array);
  text += "</" + tag + ">\n";
}

void append_polygons(std::string& text, const Polygons& polygons)
{
  Vtk_array corners{"connectivity", &vtk_type(Value_type::int32)}, ends{"offsets", corners.type};
  corners.values.assign(polygons.corners.begin(), polygons.corners.end());
  for (std::size_t f = 0; f < polygons.size(); ++f)
    ends.values.push_back(static_cast<double>(polygons.first[f + 1]));
  text += "<Polys>\n";
  append_array(text, corners);
  append_array(text, ends);
  text += "</Polys>\n";
}

}  // namespace

std::string encode_vtp(const Surface_file& file, std::vector<std::string>& notes)
{
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"" +
      std::to_string(file.points.size()) + "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" " +
      "NumberOfStrips=\"0\" NumberOfPolys=\"" + std::to_string(file.polygons.size()) + "\">\n";
  append_data(text, "PointData", vtk_vertices(file));
  append_data(text, "CellData", file.faces);
  Vtk_array points{"Points", &vtk_type(Value_type::float64), 3};
  for (const Point& point : file.points)
    points.values.insert(points.values.end(), point.begin(), point.end());
  text += "<Points>\n";
  append_array(text, points);
  text += "</Points>\n";
  append_polygons(text, file.polygons);
  note_vtk_losses(file, notes);
  return text + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace conformal
