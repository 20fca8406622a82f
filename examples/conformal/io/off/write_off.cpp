// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_off.h"

#include "conformal/io/data/encode_text.h"
#include "conformal/io/data/note_losses.h"
#include "conformal/io/data/texture_coordinates.h"

#include <optional>

namespace conformal {
namespace {

// A colour of type real needs a point, or readers take it for one of 0..255.
void append_color(std::string& text, const Property& color, std::size_t i)
{
  const std::size_t begin = text.size();
  append_value(text, color, i);
  if (!is_integer(color.type()) &&
      text.find_first_not_of("-0123456789", begin) == std::string::npos)
    text += ".0";
}

// `texture_u texture_v` are written in their own type, so that they are preserved.
std::vector<const Property*> texture_properties(const Element& vertices)
{
  const Property* u = find_numbers(vertices, "texture_u");
  const Property* v = find_numbers(vertices, "texture_v");
  if (u == nullptr || v == nullptr) return {};
  return {u, v};
}

struct Off_columns {
  explicit Off_columns(const Surface_file& file)
      : normals(normal_properties(file.vertices)),
        colors(color_properties(file.vertices)),
        texture(file.texture.index.empty() ? texture_properties(file.vertices)
                                           : std::vector<const Property*>())
  {
    if (texture.empty()) texture_rows = vertex_values(file, texture_coordinates(file));
  }

  bool has_texture() const { return !texture.empty() || texture_rows; }

  std::vector<const Property*> normals, colors, texture;
  std::optional<std::vector<std::array<double, 3>>> texture_rows;
};

void append_vertex(std::string& text, const Surface_file& file, const Off_columns& columns,
                   std::size_t v)
{
  const Point& point = file.points[v];
  append_number(text, point[0]);
  append_word(text, point[1]);
  append_word(text, point[2]);
  for (const Property* normal : columns.normals) append_value(text += ' ', *normal, v);
  for (const Property* color : columns.colors) append_color(text += ' ', *color, v);
  for (const Property* coordinate : columns.texture) append_value(text += ' ', *coordinate, v);
  for (std::size_t i = 0; columns.texture_rows && i < 2; ++i)
    append_word(text, (*columns.texture_rows)[v][i]);
  text += '\n';
}

void append_faces(std::string& text, const Surface_file& file)
{
  const auto colors = color_properties(file.faces);
  const Property* list = find_list(file.faces, "color");
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    append_number(text, static_cast<std::int64_t>(file.polygons.degree(f)));
    for (std::size_t i = file.polygons.first[f]; i < file.polygons.first[f + 1]; ++i)
      append_number(text += ' ', std::int64_t{file.polygons.corners[i]});
    for (const Property* color : colors) append_color(text += ' ', *color, f);
    for (std::size_t i = 0; colors.empty() && list != nullptr && i < list->count(f); ++i)
      append_color(text += ' ', *list, list->first(f) + i);
    text += '\n';
  }
}

Written written_to_off(const Surface_file& file, const Off_columns& columns)
{
  Written all{"OFF"};
  for (const auto& written : {columns.normals, columns.colors, columns.texture})
    for (const std::string& name : names_of(written)) all.vertices.push_back(name);
  all.faces = names_of(color_properties(file.faces));
  if (all.faces.empty() && find_list(file.faces, "color") != nullptr) all.faces = {"color"};
  all.texture = Detail::vertices;
  all.has_comments = true;
  return all;
}

}  // namespace

std::string encode_off(const Surface_file& file, std::vector<std::string>& notes)
{
  const Off_columns columns(file);
  std::string text;
  if (columns.has_texture()) text += "ST";
  if (!columns.colors.empty()) text += 'C';
  if (!columns.normals.empty()) text += 'N';
  text += "OFF\n";
  for (const std::string& comment : file.comments) text += "# " + on_one_line(comment) + '\n';
  text += std::to_string(file.points.size()) + ' ' + std::to_string(file.polygons.size()) + " 0\n";
  for (std::size_t v = 0; v < file.points.size(); ++v) append_vertex(text, file, columns, v);
  append_faces(text, file);
  note_losses(file, written_to_off(file, columns), notes);
  return text;
}

}  // namespace conformal
