// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_usda.h"

#include "conformal/io/data/encode_text.h"
#include "conformal/io/data/note_losses.h"
#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/file/io_errors.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace conformal {
namespace {

/// `[1, 2, 3]`, `[(1, 2), (3, 4)]`
class Usda_list {
 public:
  void add(const std::string& item) { m_text += (m_text.empty() ? "" : ", ") + item; }
  std::string text() const { return '[' + m_text + ']'; }

 private:
  std::string m_text;
};

std::string single(double value)
{
  std::string text;
  append_number(text, static_cast<float>(value));
  return text;
}

template <class Row>
std::string tuple(const Row& row, std::size_t size)
{
  std::string text;
  for (std::size_t i = 0; i < size; ++i) text += (i == 0 ? "(" : ", ") + single(row[i]);
  return text + ')';
}

std::string line(const std::string& what, const Usda_list& list,
                 const char* interpolation = nullptr)
{
  std::string text = "        " + what + " = " + list.text();
  if (interpolation != nullptr)
    text += std::string(" (\n            interpolation = \"") + interpolation + "\"\n        )";
  return text + '\n';
}

std::string points(const Surface_file& file, const std::string& path)
{
  Usda_list points;
  for (std::size_t v = 0; v < file.points.size(); ++v) {
    for (const double x : file.points[v])
      if (!std::isfinite(static_cast<float>(x)))
        throw Write_error(path, "vertex " + std::to_string(v) +
                                    " does not fit into USD, whose points are floats");
    points.add(tuple(file.points[v], 3));
  }
  return line("point3f[] points", points);
}

std::string faces(const Polygons& polygons)
{
  Usda_list counts, corners;
  for (std::size_t f = 0; f < polygons.size(); ++f) counts.add(std::to_string(polygons.degree(f)));
  for (const int v : polygons.corners) corners.add(std::to_string(v));
  return line("int[] faceVertexCounts", counts) + line("int[] faceVertexIndices", corners);
}

std::string texture(const Surface_file& file)
{
  const Corner_values texture = texture_coordinates(file);
  const auto& index = texture.index;
  if (index.empty() || std::find(index.begin(), index.end(), -1) != index.end()) return {};
  Usda_list values, indices;
  for (const auto& row : texture.values) values.add(tuple(row, 2));
  for (const int i : index) indices.add(std::to_string(i));
  return line("texCoord2f[] primvars:st", values, "faceVarying") +
         line("int[] primvars:st:indices", indices);
}

/// Three properties as one list of triples, times a factor
std::string triples(const char* what, const std::vector<const Property*>& columns, double factor,
                    const char* interpolation)
{
  if (columns.size() < 3) return {};
  Usda_list rows;
  for (std::size_t i = 0; i < columns[0]->rows(); ++i)
    rows.add(
        tuple(std::array<double, 3>{factor * columns[0]->value(i), factor * columns[1]->value(i),
                                    factor * columns[2]->value(i)},
              3));
  return line(what, rows, interpolation);
}

/// a name of USD: letters, digits and _
std::string identifier(const std::string& name)
{
  std::string text = std::isdigit(name[0] & 0xff) ? "_" : "";
  for (const char c : name) text += std::isalnum(c & 0xff) ? c : '_';
  return text;
}

std::string primvars(const Element& element, const std::vector<std::string>& apart,
                     const char* interpolation)
{
  std::string text;
  for (const Property& property : element.properties) {
    if (property.is_list() || std::find(apart.begin(), apart.end(), property.name()) != apart.end())
      continue;
    const bool is_whole = is_integer(property.type()) && property.type() != Value_type::uint32;
    Usda_list values;
    for (std::size_t i = 0; i < element.size; ++i)
      values.add(is_whole ? std::to_string(property.integer(i)) : single(property.value(i)));
    text += line((is_whole ? "int[] primvars:" : "float[] primvars:") + identifier(property.name()),
                 values, interpolation);
  }
  return text;
}

double of_colors(const std::vector<const Property*>& colors)
{
  return !colors.empty() && is_integer(colors[0]->type()) ? 1. / 255 : 1;
}

std::vector<std::string> names_apart(const Surface_file& file, const Element& element)
{
  std::vector<std::string> names = texture_properties(file);
  for (const auto& some :
       {names_of(color_properties(element)), names_of(normal_properties(element))})
    names.insert(names.end(), some.begin(), some.end());
  return names;
}

void note_usda_losses(const Surface_file& file, std::vector<std::string>& notes)
{
  Written all{"USD"};
  for (const Property& property : file.vertices.properties)
    if (!property.is_list() && property.name() != "alpha") all.vertices.push_back(property.name());
  for (const Property& property : file.faces.properties)
    if (!property.is_list() && property.name() != "alpha") all.faces.push_back(property.name());
  all.texture = Detail::corners;
  note_losses(file, all, notes);
}

}  // namespace

std::string encode_usda(const Surface_file& file, const std::string& path,
                        std::vector<std::string>& notes)
{
  const auto colors = color_properties(file.vertices);
  const std::string text =
      "#usda 1.0\n(\n    defaultPrim = \"surface\"\n    upAxis = \"Y\"\n)\n\n"
      "def Xform \"surface\"\n{\n    def Mesh \"mesh\"\n    {\n"  // three.js shows no mesh on its
                                                                  // own
      "        uniform token subdivisionScheme = \"none\"\n" +
      points(file, path) + faces(file.polygons) + texture(file) +
      triples("normal3f[] normals", normal_properties(file.vertices), 1, "vertex") +
      triples("color3f[] primvars:displayColor", colors, of_colors(colors), "vertex") +
      primvars(file.vertices, names_apart(file, file.vertices), "vertex") +
      primvars(file.faces, names_apart(file, file.faces), "uniform") + "    }\n}\n";
  note_usda_losses(file, notes);
  return text;
}

}  // namespace conformal
