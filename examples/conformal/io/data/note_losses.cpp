// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "note_losses.h"

#include "texture_coordinates.h"

#include <algorithm>

namespace conformal {
namespace {

bool is_in(const std::vector<std::string>& names, const std::string& name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

Detail detail_of(const Surface_file& file, const Corner_values& values)
{
  if (values.index.empty()) return Detail::none;
  return vertex_values(file, values) ? Detail::vertices : Detail::corners;
}

bool has_polygons(const Polygons& polygons)
{
  for (std::size_t f = 0; f < polygons.size(); ++f)
    if (polygons.degree(f) > 3) return true;
  return false;
}

}  // namespace

void note_losses(const Surface_file& file, const Written& written, std::vector<std::string>& notes)
{
  const auto lose = [&](bool is_lost, const std::string& what) {
    if (is_lost) notes.push_back(what + " not written to " + written.format);
  };
  const std::vector<std::string> texture_names = texture_properties(file);
  const auto lose_properties = [&](const Element& element, const std::vector<std::string>& names) {
    for (const Property& property : element.properties)
      lose(!is_in(names, property.name()) && !is_in(texture_names, property.name()),
           "the " + element.name + " property " + property.name() + " is");
  };
  lose_properties(file.vertices, written.vertices);
  lose_properties(file.faces, written.faces);
  const Corner_values texture = texture_coordinates(file);
  lose(detail_of(file, texture) > written.texture, written.texture == Detail::none
                                                       ? "texture coordinates are"
                                                       : "texture coordinates with seams are");
  lose(texture.dimension > 2 && !written.has_three_texture_coordinates,
       "third texture coordinates are");
  lose(detail_of(file, file.normals) > written.normals,
       written.normals == Detail::none ? "normals of corners are"
                                       : "normals that differ at the corners of a vertex are");
  lose(!file.group_lines.empty() && !written.has_groups, "groups and materials are");
  if (has_polygons(file.polygons) && !written.has_polygons)
    notes.push_back(std::string("polygons are written to ") + written.format + " as triangles");
  lose(!file.comments.empty() && !written.has_comments, "comments are");
  lose(!file.object_info.empty() && !written.has_object_info, "lines obj_info are");
  for (const Element& element : file.other_elements)
    lose(element.size > 0 && !written.has_elements, "the element " + element.name + " is");
}

}  // namespace conformal
