// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "rho.h"

#include "conformal/io/file/number_rows.h"
#include "conformal/io/file/read_bytes.h"
#include "conformal/process/Failure.h"
#include "conformal/process/text.h"

#include <vector>

namespace conformal {
namespace {

using On = CGP::Curvature_potential::On;

/// values of the file's vertices or faces as values of the mesh
CGP::Curvature_potential to_mesh(const Surface_input& input, On on, const std::vector<double>& all)
{
  const std::vector<int>& origin = on == On::faces ? input.face_in_file : input.vertex_in_file;
  Eigen::VectorXd values(static_cast<Eigen::Index>(origin.size()));
  for (std::size_t i = 0; i < origin.size(); ++i)
    values[static_cast<Eigen::Index>(i)] = all[static_cast<std::size_t>(origin[i])];
  return {on, std::move(values)};
}

std::string names_of(const Element& element)
{
  std::string names;
  for (const Property& property : element.properties)
    if (!property.is_list()) names += (names.empty() ? "" : ", ") + property.name();
  return names.empty() ? "none" : names;
}

std::vector<double> read_numbers(const std::string& path)
{
  std::vector<double> numbers;
  for (const Number_row& row : number_rows(read_bytes(path, "a file with numbers"), path))
    numbers.insert(numbers.end(), row.numbers.begin(), row.numbers.end());
  return numbers;
}

/// Selects the values of the elements that remain after a repair of the file
std::vector<double> left_of(const std::vector<double>& numbers, const std::vector<int>& in_file)
{
  std::vector<double> left;
  for (const int i : in_file) left.push_back(numbers[static_cast<std::size_t>(i)]);
  return left;
}

}  // namespace

CGP::Curvature_potential rho_from_property(const Surface_input& input, const Rho_options& options)
{
  const Surface_file& file = input.file;
  for (const On on : {On::vertices, On::faces}) {
    if (options.on_faces.value_or(on == On::faces) != (on == On::faces)) continue;
    const Element& element = on == On::faces ? file.faces : file.vertices;
    const Property* property = find_numbers(element, options.property);
    if (property == nullptr) continue;
    std::vector<double> values;
    for (std::size_t i = 0; i < property->rows(); ++i) values.push_back(property->value(i));
    return to_mesh(input, on, values);
  }
  throw unsuitable(file.path, "has no property '" + options.property +
                                  "'; vertices have: " + names_of(file.vertices) +
                                  "; faces have: " + names_of(file.faces));
}

CGP::Curvature_potential rho_from_file(const Surface_input& input, const Rho_options& options)
{
  const std::vector<double> numbers = read_numbers(options.file);
  const std::optional<Repair>& repair = input.repair;  // the numbers are for the file before it
  const std::size_t vertices = repair ? repair->new_vertex.size() : input.file.points.size();
  const std::size_t faces = repair ? repair->new_face.size() : input.file.polygons.size();
  if (numbers.size() == vertices && !options.on_faces.value_or(false))
    return to_mesh(input, On::vertices,
                   repair ? left_of(numbers, repair->vertex_in_file) : numbers);
  if (numbers.size() == faces && options.on_faces.value_or(true))
    return to_mesh(input, On::faces, repair ? left_of(numbers, repair->face_in_file) : numbers);
  throw unsuitable(options.file, "has " + count_of(numbers.size(), "number") +
                                     ", wanted one per vertex (" + std::to_string(vertices) +
                                     ") or one per face (" + std::to_string(faces) + ")" +
                                     (options.on_faces ? ", as --on says" : ""));
}

}  // namespace conformal
