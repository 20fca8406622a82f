// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_ply.h"

#include "conformal/io/data/encode_text.h"
#include "conformal/io/data/note_losses.h"
#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/file/little_endian.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace conformal {
namespace {

// The type that the length of a list of so many values per corner needs. A byte is what readers of
// faces expect, and the only thing some take.
Value_type length_type(const Polygons& polygons, std::size_t values_per_corner)
{
  std::size_t largest = 0;
  for (std::size_t f = 0; f < polygons.size(); ++f) largest = std::max(largest, polygons.degree(f));
  return values_per_corner * largest < 256 ? Value_type::uint8 : Value_type::int32;
}

Property converted(const Property& property, Value_type type, double factor)
{
  Property result(property.name(), type);
  result.reserve(property.rows());
  for (std::size_t i = 0; i < property.rows(); ++i) {
    const double value = property.value(i);
    result.append(is_integer(type) ? std::round(factor * value) : value);
  }
  return result;
}

bool is_in_unit_interval(const Property& property)
{
  for (std::size_t i = 0; i < property.rows(); ++i)
    if (!(property.value(i) >= 0.0 && property.value(i) <= 1.0)) return false;  // NaN, too
  return true;
}

// Colours in bytes, normals and texture coordinates in float, as expected by viewers of PLY files.
void use_common_types(Element& element)
{
  const auto colors = color_properties(element);
  if (!colors.empty() && std::all_of(colors.begin(), colors.end(), [](const Property* color) {
        return color->type() == Value_type::float64 && is_in_unit_interval(*color);
      })) {
    std::vector<Property> bytes;
    for (const Property* color : colors)
      bytes.push_back(converted(*color, Value_type::uint8, 255.0));
    for (Property& property : bytes) set_property(element, std::move(property));
  }
  for (const char* name : {"nx", "ny", "nz", "texture_u", "texture_v"}) {
    const Property* property = find_numbers(element, name);
    if (property != nullptr && property->type() == Value_type::float64)
      set_property(element, converted(*property, Value_type::float32, 1.0));
  }
}

void set_rows(Element& vertices, const std::vector<std::string>& names,
              const std::vector<std::array<double, 3>>& rows)
{
  std::vector<double> values;
  for (const auto& row : rows)
    values.insert(values.end(), row.begin(),
                  row.begin() + static_cast<std::ptrdiff_t>(names.size()));
  set_properties(vertices, names, Value_type::float32, values);
}

// a list of u, v per corner; empty for a face with a corner that has none
Property texture_list(const Surface_file& file)
{
  Property list("texcoord", length_type(file.polygons, 2), Value_type::float32);
  const auto& index = file.texture.index;
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    const auto begin = index.begin() + static_cast<std::ptrdiff_t>(file.polygons.first[f]);
    const auto end = begin + static_cast<std::ptrdiff_t>(file.polygons.degree(f));
    if (std::find(begin, end, -1) == end)
      for (auto i = begin; i != end; ++i) {
        list.append(file.texture.values[static_cast<std::size_t>(*i)][0]);
        list.append(file.texture.values[static_cast<std::size_t>(*i)][1]);
      }
    list.end_list();
  }
  return list;
}

void add_texture(const Surface_file& file, Element& vertices, Element& faces)
{
  if (file.texture.index.empty()) return;
  if (const auto rows = vertex_values(file, file.texture))
    set_rows(vertices, {"texture_u", "texture_v"}, *rows);
  else
    set_property(faces, texture_list(file));
}

void add_normals(const Surface_file& file, Element& vertices)
{
  if (const auto rows = vertex_values(file, file.normals))
    set_rows(vertices, {"nx", "ny", "nz"}, *rows);
}

Written written_to_ply(const Surface_file& file)
{
  Written all{"PLY"};
  for (const Property& property : file.vertices.properties) all.vertices.push_back(property.name());
  for (const Property& property : file.faces.properties) all.faces.push_back(property.name());
  all.texture = Detail::corners;
  all.normals = Detail::vertices;
  all.has_comments = all.has_object_info = all.has_elements = true;
  return all;
}

class Ply_writer {
 public:
  explicit Ply_writer(Ply_encoding encoding) : m_encoding(encoding)
  {
    constexpr std::array names = {"ascii", "binary_little_endian", "binary_big_endian"};
    m_bytes = std::string("ply\nformat ") + names[static_cast<std::size_t>(encoding)] + " 1.0\n";
  }

  void write_lines(const char* keyword, const std::vector<std::string>& lines)
  {
    for (const std::string& line : lines) m_bytes += keyword + (' ' + on_one_line(line)) + '\n';
  }

  void write_line(const std::string& line) { m_bytes += line + '\n'; }

  void write_properties(const Element& element)
  {
    for (const Property& property : element.properties) {
      m_bytes += "property ";
      if (property.is_list()) m_bytes.append("list ").append(name_of(property.count_type())) += ' ';
      m_bytes.append(name_of(property.type())) += ' ' + property.name() + '\n';
    }
  }

  template <class Number>
  void write_number(Number number)
  {
    if (m_encoding == Ply_encoding::ascii) {
      if constexpr (std::is_integral_v<Number>)
        append_number(m_bytes, std::int64_t{number});
      else
        append_number(m_bytes, number);
      m_bytes += ' ';
    } else {
      append_little_endian(m_bytes, number);
      turn(sizeof number);
    }
  }

  // the length of a list
  void write_count(Value_type type, std::size_t count)
  {
    Property number("", type);
    number.append(static_cast<double>(count));
    write_value(number, 0);
  }

  void write_row(const Element& element, std::size_t row)
  {
    for (const Property& property : element.properties) {
      if (property.is_list()) write_count(property.count_type(), property.count(row));
      for (std::size_t i = 0; i < property.count(row); ++i)
        write_value(property, property.first(row) + i);
    }
    end_row();
  }

  void end_row()
  {
    if (m_encoding == Ply_encoding::ascii && !m_bytes.empty() && m_bytes.back() == ' ')
      m_bytes.back() = '\n';
  }

  std::string take() { return std::move(m_bytes); }

 private:
  void write_value(const Property& property, std::size_t i)
  {
    if (m_encoding == Ply_encoding::ascii) {
      append_value(m_bytes, property, i);
      m_bytes += ' ';
    } else {
      append_little_endian(m_bytes, property.bytes(i), size_of(property.type()));
      turn(size_of(property.type()));
    }
  }

  // the last bytes into the order of the encoding
  void turn(std::size_t size)
  {
    if (m_encoding == Ply_encoding::big_endian)
      std::reverse(m_bytes.end() - static_cast<std::ptrdiff_t>(size), m_bytes.end());
  }

  Ply_encoding m_encoding;
  std::string m_bytes;
};

void write_header(Ply_writer& writer, const Surface_file& file, const Element& vertices,
                  const Element& faces, Value_type degree_type, Value_type coordinates)
{
  writer.write_lines("comment", file.comments);
  writer.write_lines("obj_info", file.object_info);
  writer.write_line("element vertex " + std::to_string(file.points.size()));
  for (const char* name : {"x", "y", "z"})
    writer.write_line("property " + std::string(name_of(coordinates)) + ' ' + name);
  writer.write_properties(vertices);
  writer.write_line("element face " + std::to_string(file.polygons.size()));
  writer.write_line("property list " + std::string(name_of(degree_type)) + " int vertex_indices");
  writer.write_properties(faces);
  for (const Element& element : file.other_elements) {
    if (element.size == 0) continue;  // some readers fail at elements that they do not know
    writer.write_line("element " + element.name + ' ' + std::to_string(element.size));
    writer.write_properties(element);
  }
  writer.write_line("end_header");
}

void write_face(Ply_writer& writer, const Polygons& polygons, std::size_t f, Value_type degree_type)
{
  writer.write_count(degree_type, polygons.degree(f));
  for (std::size_t i = polygons.first[f]; i < polygons.first[f + 1]; ++i)
    writer.write_number(std::int32_t{polygons.corners[i]});
}

}  // namespace

std::string encode_ply(const Surface_file& file, const Ply_style& style,
                       std::vector<std::string>& notes)
{
  Element vertices = file.vertices, faces = file.faces;
  if (file.format != File_format::ply) {
    use_common_types(vertices);
    use_common_types(faces);
  }
  add_texture(file, vertices, faces);
  add_normals(file, vertices);
  note_losses(file, written_to_ply(file), notes);
  const Value_type degree_type = length_type(file.polygons, 1);
  const bool is_single = style.coordinates == Value_type::float32;
  Ply_writer writer(style.encoding);
  write_header(writer, file, vertices, faces, degree_type, style.coordinates);
  for (std::size_t v = 0; v < file.points.size(); ++v) {
    for (const double x : file.points[v])
      is_single ? writer.write_number(static_cast<float>(x)) : writer.write_number(x);
    writer.write_row(vertices, v);
  }
  for (std::size_t f = 0; f < file.polygons.size(); ++f) {
    write_face(writer, file.polygons, f, degree_type);
    writer.write_row(faces, f);
  }
  for (const Element& element : file.other_elements)
    for (std::size_t row = 0; row < element.size; ++row)
      if (!element.properties.empty()) writer.write_row(element, row);
  return writer.take();
}

}  // namespace conformal
