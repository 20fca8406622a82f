// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Left_out.h"
#include "conformal/io/data/Surface_file.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// a type of numbers of VTK, with its names in legacy and in XML files
struct Vtk_type {
  std::string_view legacy, xml;
  Value_type kept;  ///< the type of a property with such numbers
  std::size_t size;
  double (*read)(const char* little_endian_bytes);
  void (*append)(std::string& bytes, double value);  ///< little endian
};

/// null for names that are none; legacy files have more than one for integers of 64 bits
const Vtk_type* vtk_type(std::string_view name);
const Vtk_type& vtk_type(Value_type type);

/// rows of numbers that belong to points or faces
struct Vtk_array {
  std::string name;
  const Vtk_type* type = nullptr;
  std::size_t width = 1;  ///< numbers in a row
  std::vector<double> values = {};

  std::size_t rows() const { return values.size() / width; }
};

/// \brief Stores arrays as properties: three numbers called `Normals` as `nx ny nz`, two or three
/// called `TCoords` as `texture_u texture_v`, three or four bytes as colours, others with more than
/// one number in a row as `NAME_0 NAME_1 ...`.
/// \param skipped rows before the first one of the element
void set_arrays(Element& element, std::vector<Vtk_array> arrays, std::size_t skipped,
                Left_out& left_out);

/// The properties of an element as arrays, in the same way; lists are not arrays.
std::vector<Vtk_array> arrays_of(const Element& element);

/// the vertices with texture coordinates and normals, where they do not jump
Element vtk_vertices(const Surface_file& file);

/// Adds what was lost.
void note_vtk_losses(const Surface_file& file, std::vector<std::string>& notes);

}  // namespace conformal
