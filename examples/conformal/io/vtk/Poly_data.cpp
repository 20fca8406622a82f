// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Poly_data.h"

#include "conformal/io/data/note_losses.h"
#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/file/little_endian.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace conformal {
namespace {

template <class Number>
double read_number(const char* bytes)
{
  return static_cast<double>(little_endian<Number>(bytes));
}

template <class Number>
void append_number(std::string& bytes, double value)
{
  append_little_endian(bytes, static_cast<Number>(value));
}

template <class Number>
Vtk_type type_of(std::string_view legacy, std::string_view xml, Value_type kept)
{
  return {legacy, xml, kept, sizeof(Number), read_number<Number>, append_number<Number>};
}

const std::array<Vtk_type, 13>& all_types()
{
  using T = Value_type;
  static const std::array<Vtk_type, 13> all = {
      type_of<std::int8_t>("char", "Int8", T::int8),
      type_of<std::uint8_t>("unsigned_char", "UInt8", T::uint8),
      type_of<std::int16_t>("short", "Int16", T::int16),
      type_of<std::uint16_t>("unsigned_short", "UInt16", T::uint16),
      type_of<std::int32_t>("int", "Int32", T::int32),
      type_of<std::uint32_t>("unsigned_int", "UInt32", T::uint32),
      type_of<float>("float", "Float32", T::float32),
      type_of<double>("double", "Float64", T::float64),
      type_of<std::int64_t>("vtktypeint64", "Int64", T::float64),
      type_of<std::uint64_t>("vtktypeuint64", "UInt64", T::float64),
      type_of<std::int64_t>("long", "", T::float64),
      type_of<std::uint64_t>("unsigned_long", "", T::float64),
      // of 32 bits in legacy files, whatever it is elsewhere
      type_of<std::int32_t>("vtkIdType", "", T::int32)};
  return all;
}

using Names = std::vector<std::string>;

const Names colors = {"red", "green", "blue", "alpha"};

/// what the columns of an array are called as properties
Names columns_of(const Vtk_array& array)
{
  const bool is_bytes = array.type->kept == Value_type::uint8;
  if (array.width == 1) return {array.name};
  if (array.width == 3 && array.name == "Normals") return {"nx", "ny", "nz"};
  if (array.width <= 3 && array.name == "TCoords") return {"texture_u", "texture_v"};
  if (is_bytes && (array.width == 3 || array.width == 4))
    return Names(colors.begin(), colors.begin() + static_cast<std::ptrdiff_t>(array.width));
  Names names;
  for (std::size_t k = 0; k < array.width; ++k)
    names.push_back(array.name + '_' + std::to_string(k));
  return names;
}

/// The other way round: the array that begins with a property, and its columns.
std::pair<std::string, Names> array_from(const Element& element, const std::string& name)
{
  const auto has = [&](const std::string& other) {
    const Property* property = find_numbers(element, other);
    return property != nullptr && property->type() == find_numbers(element, name)->type();
  };
  for (const auto& [array, columns] : std::vector<std::pair<std::string, Names>>{
           {"Normals", {"nx", "ny", "nz"}}, {"TCoords", {"texture_u", "texture_v"}}})
    if (name == columns[0] && std::all_of(columns.begin(), columns.end(), has))
      return {array, columns};
  if (name == colors[0] && has("green") && has("blue") &&
      find_numbers(element, name)->type() == Value_type::uint8)
    return {"Colors", Names(colors.begin(), colors.end() - (has("alpha") ? 0 : 1))};
  Names columns = {name};
  if (name.size() > 2 && name.substr(name.size() - 2) == "_0") {
    const std::string stem = name.substr(0, name.size() - 2);
    while (has(stem + '_' + std::to_string(columns.size())))
      columns.push_back(stem + '_' + std::to_string(columns.size()));
    if (columns.size() > 1) return {stem, columns};
  }
  return {name, columns};
}

/// a name that a PLY header can have, too
std::string property_name(std::string name)
{
  for (char& c : name)
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r') c = '_';
  return name;
}

bool has_whole_numbers(const Vtk_array& array)
{
  return array.type->kept == Value_type::float64 && array.type->xml != "Float64" &&
         std::all_of(array.values.begin(), array.values.end(),
                     [](double x) { return std::abs(x) <= 2147483647; });
}

/// Texts may have other numbers than their type.
bool fits(const Vtk_array& array, Value_type type)
{
  return !is_integer(type) || std::all_of(array.values.begin(), array.values.end(), [&](double x) {
    return std::abs(x) < 1e15 && std::floor(x) == x && fits(type, static_cast<std::int64_t>(x));
  });
}

}  // namespace

const Vtk_type* vtk_type(std::string_view name)
{
  const auto& all = all_types();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Vtk_type& type) {
    return type.legacy == name || type.xml == name;
  });
  return name.empty() || found == all.end() ? nullptr : &*found;
}

const Vtk_type& vtk_type(Value_type type)
{
  return all_types()[static_cast<std::size_t>(type)];
}

void set_arrays(Element& element, std::vector<Vtk_array> arrays, std::size_t skipped,
                Left_out& left_out)
{
  for (Vtk_array& array : arrays) {
    array.name = property_name(array.name);
    const Names columns = columns_of(array);
    const Value_type type = has_whole_numbers(array) ? Value_type::int32 : array.type->kept;
    const bool has_rows = array.rows() >= skipped + element.size && !array.values.empty();
    if (!has_rows || !fits(array, type) ||
        !std::all_of(columns.begin(), columns.end(), is_property_name)) {
      left_out.add("arrays without a name, of another length, or with numbers of another type",
                   array.name);
      continue;
    }
    for (std::size_t k = 0; k < columns.size(); ++k) {
      Property property(columns[k], type);
      for (std::size_t i = 0; i < element.size; ++i)
        property.append(array.values[(skipped + i) * array.width + k]);
      set_property(element, std::move(property));
    }
  }
}

std::vector<Vtk_array> arrays_of(const Element& element)
{
  std::vector<Vtk_array> arrays;
  Names done;
  for (const Property& first : element.properties) {
    if (first.is_list() || std::find(done.begin(), done.end(), first.name()) != done.end())
      continue;
    const auto [name, columns] = array_from(element, first.name());
    done.insert(done.end(), columns.begin(), columns.end());
    Vtk_array array{name, &vtk_type(first.type()), columns.size()};
    for (std::size_t i = 0; i < element.size; ++i)
      for (const std::string& column : columns)
        array.values.push_back(find_numbers(element, column)->value(i));
    arrays.push_back(std::move(array));
  }
  return arrays;
}

Element vtk_vertices(const Surface_file& file)
{
  Element vertices = file.vertices;
  const auto add = [&](const Corner_values& corners, const Names& names) {
    const auto rows = corners.empty() ? std::nullopt : vertex_values(file, corners);
    if (!rows) return;
    std::vector<double> values;
    for (const auto& row : *rows)
      values.insert(values.end(), row.begin(),
                    row.begin() + static_cast<std::ptrdiff_t>(names.size()));
    set_properties(vertices, names, Value_type::float64, values);
  };
  if (texture_properties(file).size() < 2)  // they are not at vertices yet
    add(texture_coordinates(file), {"texture_u", "texture_v"});
  add(file.normals, {"nx", "ny", "nz"});
  return vertices;
}

void note_vtk_losses(const Surface_file& file, std::vector<std::string>& notes)
{
  Written all{"VTK"};
  for (const Property& property : vtk_vertices(file).properties)
    if (!property.is_list()) all.vertices.push_back(property.name());
  for (const Property& property : file.faces.properties)
    if (!property.is_list()) all.faces.push_back(property.name());
  all.texture = all.normals = Detail::vertices;
  note_losses(file, all, notes);
}

}  // namespace conformal
