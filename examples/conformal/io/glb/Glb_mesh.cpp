// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Glb_mesh.h"

#include "attribute_names.h"

#include "conformal/io/data/texture_coordinates.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace conformal {
namespace {

// Which vertex and which row of texture coordinates each vertex of the result is.
struct Copies {
  std::vector<std::size_t> vertex;
  std::vector<int> row;               // -1: none
  std::vector<std::uint32_t> corner;  // the vertex of the result at each corner
};

Copies copies_at_seams(const Surface_file& file, const Corner_values& texture)
{
  const std::size_t n = file.points.size();
  Copies copies;
  for (std::size_t v = 0; v < n; ++v) copies.vertex.push_back(v);
  copies.row.assign(n, -1);
  std::vector<bool> is_used(n, false);
  std::map<std::pair<std::size_t, int>, std::uint32_t> others;
  for (std::size_t i = 0; i < file.polygons.corners.size(); ++i) {
    const auto v = static_cast<std::size_t>(file.polygons.corners[i]);
    const int row = texture.index.empty() ? -1 : texture.index[i];
    if (!is_used[v]) copies.row[v] = row;
    is_used[v] = true;
    auto copy = static_cast<std::uint32_t>(v);
    if (copies.row[v] != row) {
      const auto next = static_cast<std::uint32_t>(copies.vertex.size());
      const auto [place, is_new] = others.try_emplace({v, row}, next);
      copy = place->second;
      if (is_new) copies.vertex.push_back(v);
      if (is_new) copies.row.push_back(row);
    }
    copies.corner.push_back(copy);
  }
  return copies;
}

Point middle_of(const std::vector<Point>& points)
{
  Point low = points.front(), high = low, middle{};
  for (const Point& point : points)
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], point[i]);
      high[i] = std::max(high[i], point[i]);
    }
  for (std::size_t i = 0; i < 3; ++i) middle[i] = 0.5 * low[i] + 0.5 * high[i];
  return middle;
}

// Half the vector areas of the faces around each vertex; Newell's formula for polygons.
std::vector<Point> area_normals(const Surface_file& file, const Point& middle)
{
  std::vector<Point> normals(file.points.size(), Point{});
  const auto& corners = file.polygons.corners;
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    Point sum{};
    const std::size_t begin = file.polygons.first[f], end = file.polygons.first[f + 1];
    for (std::size_t i = begin; i < end; ++i) {
      const Point& p = file.points[static_cast<std::size_t>(corners[i])];
      const Point& q = file.points[static_cast<std::size_t>(corners[i + 1 < end ? i + 1 : begin])];
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        sum[k] += (p[l] - middle[l]) * (q[m] - middle[m]) - (p[m] - middle[m]) * (q[l] - middle[l]);
      }
    }
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        normals[static_cast<std::size_t>(corners[i])][k] += sum[k];
  }
  return normals;
}

std::vector<Point> vertex_normals(const Surface_file& file, const Point& middle)
{
  if (const auto rows = vertex_values(file, file.normals)) return *rows;
  const auto given = normal_properties(file.vertices);
  if (given.empty()) return area_normals(file, middle);
  std::vector<Point> normals(file.points.size());
  for (std::size_t v = 0; v < normals.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) normals[v][i] = given[i]->value(v);
  return normals;
}

// GLB demands normals of length 1; a vertex without one gets the z axis.
std::array<float, 3> normalized(const Point& normal)
{
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  if (!(length > 0.0) || !std::isfinite(length)) return {0.0f, 0.0f, 1.0f};
  return {static_cast<float>(normal[0] / length), static_cast<float>(normal[1] / length),
          static_cast<float>(normal[2] / length)};
}

// Not-a-number has no place in GLB; it becomes 0.
float finite(double value)
{
  return std::isfinite(value) ? static_cast<float>(value) : 0.0f;
}

unsigned char color_byte(const Property& color, std::size_t v)
{
  const double largest = color.type() == Value_type::uint16 ? 65535.0 : 255.0;
  const double value = is_integer(color.type()) ? color.value(v) / largest : color.value(v);
  return static_cast<unsigned char>(
      std::lround(255.0 * std::clamp<double>(finite(value), 0.0, 1.0)));
}

std::vector<std::array<unsigned char, 4>> color_rows(const Surface_file& file, const Copies& copies)
{
  const auto properties = color_properties(file.vertices);
  std::vector<std::array<unsigned char, 4>> colors;
  if (properties.empty()) return colors;
  for (const std::size_t v : copies.vertex) {
    std::array<unsigned char, 4> color = {0, 0, 0, 255};
    for (std::size_t i = 0; i < properties.size(); ++i) color[i] = color_byte(*properties[i], v);
    colors.push_back(color);
  }
  return colors;
}

// Nothing if a value does not fit, since GLB has no not-a-number.
std::vector<std::array<float, 1>> value_rows(const Property& property, const Copies& copies)
{
  std::vector<std::array<float, 1>> rows;
  for (const std::size_t v : copies.vertex) {
    rows.push_back({static_cast<float>(property.value(v))});
    if (!std::isfinite(rows.back()[0])) return {};
  }
  return rows;
}

std::vector<Glb_mesh::Values> all_values(const Surface_file& file, const Copies& copies)
{
  std::vector<std::string> others = texture_properties(file);
  for (const auto& properties : {normal_properties(file.vertices), color_properties(file.vertices)})
    for (const std::string& name : names_of(properties)) others.push_back(name);
  std::vector<Glb_mesh::Values> all;
  for (const Property& property : file.vertices.properties) {
    const auto name = attribute_of(property.name());
    if (!name || property.is_list() || std::count(others.begin(), others.end(), property.name()))
      continue;
    all.push_back({property.name(), *name, value_rows(property, copies)});
    if (all.back().rows.empty()) all.pop_back();
  }
  return all;
}

std::vector<std::array<float, 2>> texture_rows(const Corner_values& texture, const Copies& copies)
{
  std::vector<std::array<float, 2>> result;
  if (texture.index.empty()) return result;
  for (const int row : copies.row) {
    const auto uv =
        row < 0 ? std::array<double, 3>{} : texture.values[static_cast<std::size_t>(row)];
    result.push_back({finite(uv[0]), finite(1.0 - uv[1])});
  }
  return result;
}

std::vector<std::array<std::uint32_t, 3>> fans(const Polygons& polygons, const Copies& copies)
{
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::size_t f = 0; f < polygons.size(); ++f)
    for (std::size_t i = polygons.first[f] + 2; i < polygons.first[f + 1]; ++i)
      triangles.push_back(
          {copies.corner[polygons.first[f]], copies.corner[i - 1], copies.corner[i]});
  return triangles;
}

}  // namespace

Glb_mesh glb_mesh(const Surface_file& file)
{
  Glb_mesh mesh;
  mesh.middle = middle_of(file.points);
  const Corner_values texture = texture_coordinates(file);
  const Copies copies = copies_at_seams(file, texture);
  const std::vector<Point> normals = vertex_normals(file, mesh.middle);
  for (const std::size_t v : copies.vertex) {
    std::array<float, 3> position;
    for (std::size_t i = 0; i < 3; ++i)
      position[i] = static_cast<float>(file.points[v][i] - mesh.middle[i]);
    mesh.positions.push_back(position);
    mesh.normals.push_back(normalized(normals[v]));
  }
  mesh.texture = texture_rows(texture, copies);
  mesh.colors = color_rows(file, copies);
  mesh.values = all_values(file, copies);
  mesh.triangles = fans(file.polygons, copies);
  return mesh;
}

}  // namespace conformal
