// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "texture_coordinates.h"

#include <cstring>
#include <map>
#include <stdexcept>

namespace conformal {
namespace {

struct Pair_of_names {
  const char *u, *v;
};
constexpr std::array<Pair_of_names, 3> vertex_names = {
    {{"texture_u", "texture_v"}, {"s", "t"}, {"u", "v"}}};
constexpr const char* list_name = "texcoord";

Corner_values from_vertices(const Surface_file& file, const Property& u, const Property& v)
{
  Corner_values texture;
  for (std::size_t i = 0; i < file.points.size(); ++i)
    texture.values.push_back({u.value(i), v.value(i), 0.0});
  texture.index = file.polygons.corners;
  return texture;
}

// One row for each vertex and pair of coordinates that differ in a bit, in order of appearance.
class Row_merger {
 public:
  explicit Row_merger(Corner_values& texture) : m_texture(texture) {}

  int row(int vertex, double u, double v)
  {
    const auto [place, is_new] =
        m_rows.try_emplace({vertex, bits(u), bits(v)}, static_cast<int>(m_texture.values.size()));
    if (is_new) m_texture.values.push_back({u, v, 0.0});
    return place->second;
  }

 private:
  static std::uint64_t bits(double x)
  {
    std::uint64_t result;
    std::memcpy(&result, &x, sizeof x);
    return result;
  }

  Corner_values& m_texture;
  std::map<std::tuple<int, std::uint64_t, std::uint64_t>, int> m_rows;
};

// A face whose list does not have two values for every corner has no texture coordinates.
Corner_values from_faces(const Surface_file& file, const Property& list)
{
  Corner_values texture;
  texture.index.assign(file.polygons.corners.size(), -1);
  Row_merger rows(texture);
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    if (list.count(f) != 2 * file.polygons.degree(f)) continue;
    for (std::size_t k = 0; k < file.polygons.degree(f); ++k) {
      const std::size_t corner = file.polygons.first[f] + k, i = list.first(f) + 2 * k;
      texture.index[corner] =
          rows.row(file.polygons.corners[corner], list.value(i), list.value(i + 1));
    }
  }
  return texture;
}

}  // namespace

std::vector<std::string> texture_properties(const Surface_file& file)
{
  if (!file.texture.index.empty()) return {};
  if (find_list(file.faces, list_name) != nullptr) return {list_name};
  for (const auto& [u, v] : vertex_names)
    if (find_numbers(file.vertices, u) != nullptr && find_numbers(file.vertices, v) != nullptr)
      return {u, v};
  return {};
}

Corner_values texture_coordinates(const Surface_file& file)
{
  const std::vector<std::string> names = texture_properties(file);
  if (names.empty()) return file.texture.index.empty() ? Corner_values() : file.texture;
  if (names.size() == 1) return from_faces(file, *find_list(file.faces, names[0]));
  return from_vertices(file, *find_numbers(file.vertices, names[0]),
                       *find_numbers(file.vertices, names[1]));
}

void set_texture_coordinates(Surface_file& file, Corner_values values)
{
  if (!values.empty() && values.index.size() != file.polygons.corners.size())
    throw std::invalid_argument(
        "set_texture_coordinates(): " + std::to_string(values.index.size()) + " corners, wanted " +
        std::to_string(file.polygons.corners.size()));
  remove_property(file.faces, list_name);
  for (const auto& [u_name, v_name] : vertex_names)
    if (find_numbers(file.vertices, u_name) != nullptr &&
        find_numbers(file.vertices, v_name) != nullptr) {
      remove_property(file.vertices, u_name);
      remove_property(file.vertices, v_name);
    }
  file.texture = std::move(values);
}

void set_texture_coordinates(Surface_file& file, const std::vector<std::array<double, 2>>& values)
{
  if (values.size() != file.points.size())
    throw std::invalid_argument("set_texture_coordinates(): " + std::to_string(values.size()) +
                                " vertices, wanted " + std::to_string(file.points.size()));
  Corner_values texture;
  for (const auto& [u, v] : values) texture.values.push_back({u, v, 0.0});
  texture.index = file.polygons.corners;
  set_texture_coordinates(file, std::move(texture));
}

void list_to_corners(Surface_file& file)
{
  if (find_list(file.faces, list_name) != nullptr)
    set_texture_coordinates(file, texture_coordinates(file));
}

std::optional<std::vector<std::array<double, 3>>> vertex_values(const Surface_file& file,
                                                                const Corner_values& values)
{
  if (values.index.empty()) return {};
  std::vector<int> row(file.points.size(), -1);
  for (std::size_t i = 0; i < values.index.size(); ++i) {
    int& present = row[static_cast<std::size_t>(file.polygons.corners[i])];
    if (values.index[i] < 0 || (present >= 0 && present != values.index[i])) return {};
    present = values.index[i];
  }
  std::vector<std::array<double, 3>> result(file.points.size());
  for (std::size_t v = 0; v < row.size(); ++v)
    if (row[v] >= 0) result[v] = values.values[static_cast<std::size_t>(row[v])];
  return result;
}

}  // namespace conformal
