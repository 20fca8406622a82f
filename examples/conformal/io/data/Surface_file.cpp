// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Surface_file.h"

#include <algorithm>

namespace conformal {
namespace {

const char* const try_repair = "; try: --repair";

// The first index that occurs twice, or the end. Sorting a copy costs memory only for large faces.
const std::int64_t* find_repeated(const std::int64_t* begin, const std::int64_t* end)
{
  constexpr std::ptrdiff_t small = 16;
  if (end - begin <= small) {
    for (const std::int64_t* i = begin; i != end; ++i)
      if (std::find(begin, i, *i) != i) return i;
    return end;
  }
  std::vector<std::int64_t> sorted(begin, end);
  std::sort(sorted.begin(), sorted.end());
  const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
  return twice == sorted.end() ? end : std::find(begin, end, *twice);
}

}  // namespace

std::vector<const Property*> color_properties(const Element& element)
{
  std::vector<const Property*> colors;
  for (const char* name : {"red", "green", "blue", "alpha"}) {
    const Property* property = find_numbers(element, name);
    if (property != nullptr)
      colors.push_back(property);
    else if (colors.size() < 3)
      return {};
  }
  return colors;
}

std::vector<const Property*> normal_properties(const Element& element)
{
  std::vector<const Property*> normals;
  for (const char* name : {"nx", "ny", "nz"})
    if (const Property* property = find_numbers(element, name)) normals.push_back(property);
  return normals.size() == 3 ? normals : std::vector<const Property*>();
}

std::vector<std::string> names_of(const std::vector<const Property*>& properties)
{
  std::vector<std::string> names;
  for (const Property* property : properties) names.push_back(property->name());
  return names;
}

void set_properties(Element& element, const std::vector<std::string>& names, Value_type type,
                    const std::vector<double>& values)
{
  for (std::size_t i = 0; i < names.size(); ++i) {
    Property property(names[i], type);
    property.reserve(element.size);
    for (std::size_t k = i; k < values.size(); k += names.size()) property.append(values[k]);
    set_property(element, std::move(property));
  }
}

bool remove_normals(Surface_file& file)
{
  bool has_any = !file.normals.empty();
  file.normals = Corner_values();
  for (Element* element : {&file.vertices, &file.faces})
    for (const char* name : {"nx", "ny", "nz"}) {
      if (find_numbers(*element, name) == nullptr) continue;
      remove_property(*element, name);
      has_any = true;
    }
  return has_any;
}

std::string fault_of_face(const std::int64_t* begin, const std::int64_t* end, std::size_t n,
                          int base, Bad_faces bad_faces)
{
  const bool is_strict = bad_faces == Bad_faces::refused;
  if (is_strict && end - begin < 3)
    return "a face of " + std::to_string(end - begin) + " corners, wanted at least 3" + try_repair;
  for (const std::int64_t* i = begin; i != end; ++i)
    if (*i < 0 || *i >= static_cast<std::int64_t>(n))
      return "a face has the vertex index " + std::to_string(*i + base) + ", wanted " +
             std::to_string(base) + " to " +
             std::to_string(static_cast<std::int64_t>(n) - 1 + base);
  const std::int64_t* repeated = is_strict ? find_repeated(begin, end) : end;
  if (repeated != end)
    return "a face has the vertex " + std::to_string(*repeated + base) +
           " twice, wanted different corners" + try_repair;
  return {};
}

void append_face(Polygons& polygons, const std::int64_t* begin, const std::int64_t* end)
{
  for (const std::int64_t* i = begin; i != end; ++i)
    polygons.corners.push_back(static_cast<int>(*i));
  polygons.first.push_back(polygons.corners.size());
}

}  // namespace conformal
