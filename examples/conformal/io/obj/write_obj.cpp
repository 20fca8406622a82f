// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_obj.h"

#include "conformal/io/data/encode_text.h"
#include "conformal/io/data/note_losses.h"
#include "conformal/io/data/texture_coordinates.h"

namespace conformal {
namespace {

// OBJ colours are in 0..1.
void append_unit_color(std::string& text, const Property& color, std::size_t v)
{
  text += ' ';
  if (is_integer(color.type()))
    append_number(text, color.value(v) / 255.0);
  else
    append_value(text, color, v);
}

void append_vertices(std::string& text, const Surface_file& file)
{
  const auto colors = color_properties(file.vertices);
  for (std::size_t v = 0; v < file.points.size(); ++v) {
    text += 'v';
    for (const double x : file.points[v]) append_word(text, x);
    for (const Property* color : colors) append_unit_color(text, *color, v);
    text += '\n';
  }
}

void append_rows(std::string& text, const char* keyword, const Corner_values& values)
{
  for (const auto& row : values.values) {
    text += keyword;
    for (std::size_t i = 0; i < values.dimension; ++i) append_word(text, row[i]);
    text += '\n';
  }
}

// The normals of the corners, from those of the vertices if necessary
Corner_values normals_of(const Surface_file& file)
{
  Corner_values normals = file.normals;
  normals.dimension = 3;
  const auto given = normal_properties(file.vertices);
  if (!normals.empty() || given.empty()) return normals;
  for (std::size_t v = 0; v < file.points.size(); ++v)
    normals.values.push_back({given[0]->value(v), given[1]->value(v), given[2]->value(v)});
  normals.index = file.polygons.corners;
  return normals;
}

// v, v/vt, v//vn or v/vt/vn
void append_corner(std::string& text, std::int64_t vertex, std::int64_t texture,
                   std::int64_t normal)
{
  append_number(text += ' ', vertex + 1);
  if (texture >= 0) append_number(text += '/', texture + 1);
  if (normal >= 0) append_number(text += texture >= 0 ? "/" : "//", normal + 1);
}

void append_faces(std::string& text, const Surface_file& file, const Corner_values& texture,
                  const Corner_values& normals)
{
  auto line = file.group_lines.begin();
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    for (; line != file.group_lines.end() && line->face <= f; ++line)
      text += on_one_line(line->text) + '\n';
    text += 'f';
    for (std::size_t i = file.polygons.first[f]; i < file.polygons.first[f + 1]; ++i)
      append_corner(text, file.polygons.corners[i], texture.index.empty() ? -1 : texture.index[i],
                    normals.index.empty() ? -1 : normals.index[i]);
    text += '\n';
  }
  for (; line != file.group_lines.end(); ++line) text += on_one_line(line->text) + '\n';
}

Written written_to_obj(const Surface_file& file)
{
  Written all{"OBJ"};
  all.vertices = names_of(normal_properties(file.vertices));
  for (const std::string& name : names_of(color_properties(file.vertices)))
    all.vertices.push_back(name);
  all.texture = all.normals = Detail::corners;
  all.has_comments = all.has_groups = all.has_three_texture_coordinates = true;
  return all;
}

}  // namespace

std::string encode_obj(const Surface_file& file, std::vector<std::string>& notes)
{
  const Corner_values texture =
      file.texture.empty() ? texture_coordinates(file) : file.texture;  // rows without faces, too
  const Corner_values normals = normals_of(file);
  std::string text;
  for (const std::string& comment : file.comments) text += "# " + on_one_line(comment) + '\n';
  append_vertices(text, file);
  append_rows(text, "vt", texture);
  append_rows(text, "vn", normals);
  append_faces(text, file, texture, normals);
  note_losses(file, written_to_obj(file), notes);
  return text;
}

}  // namespace conformal
