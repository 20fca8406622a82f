// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Property.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace conformal {

enum class File_format { off, obj, ply, stl, glb, gltf, vtk, vtp, usda };

using Point = std::array<double, 3>;

/// The corners of polygons, one after the other: face f has the vertices
/// `corners[first[f]], ..., corners[first[f + 1] - 1]`, counted from 0.
struct Polygons {
  std::vector<std::size_t> first = {0};
  std::vector<int> corners;

  std::size_t size() const { return first.size() - 1; }
  std::size_t degree(std::size_t f) const { return first[f + 1] - first[f]; }
};

/// Values that belong to the corners of the faces, so that they may jump across an edge (a seam):
/// a table, and for every corner of `Polygons::corners` a row of the table, or -1 for none.
struct Corner_values {
  std::size_t dimension = 2;  // number of valid entries per row
  std::vector<std::array<double, 3>> values;
  std::vector<int> index;  // as many as corners, or none at all

  bool empty() const { return values.empty(); }
};

/// A line of an OBJ file (`g`, `o`, `s`, `usemtl`, `mtllib`) and the face that it precedes.
struct Group_line {
  std::size_t face;
  std::string text;
};

/// The contents of a mesh file, without repair, merging, reordering or omissions. (STL has no
/// vertices: corners of exactly equal coordinates are one vertex, numbered by first appearance.)
///
/// The readers guarantee: coordinates are finite, indices are in range, a face has at least three
/// corners, all different (unless `Bad_faces::kept` was asked for). They promise nothing about
/// areas, manifoldness or orientation.
///
/// Colours are the properties `red green blue [alpha]` of vertices or faces, 0..255 where their
/// type is an integer, 0..1 where it is not; vertex normals are `nx ny nz`; these are the names of
/// PLY, and OFF and OBJ files are read into them. Texture coordinates stay where they were: in
/// `texture` (OBJ) or in properties; `texture_coordinates()` finds either.
struct Surface_file {
  std::string path;
  File_format format = File_format::ply;

  std::vector<Point> points;
  Polygons polygons;

  Element vertices{"vertex", 0, {}};  // without x, y, z
  Element faces{"face", 0, {}};       // without the vertex indices
  std::vector<Element> other_elements;

  Corner_values texture;  // OBJ `vt`
  Corner_values normals;  // OBJ `vn`

  std::vector<std::string> comments;  // without `#` or `comment`; `TextureFile ...` is among them
  std::vector<std::string> object_info;  // PLY `obj_info`
  std::vector<Group_line> group_lines;

  std::vector<std::string> notes;  // for the user: what was left out, and why
};

/// Whether four properties or three hold colours, in the order red, green, blue, alpha; empty if
/// the element has no colours.
std::vector<const Property*> color_properties(const Element& element);

/// The properties `nx ny nz`, or none if one of them is not there
std::vector<const Property*> normal_properties(const Element& element);

/// their names
std::vector<std::string> names_of(const std::vector<const Property*>& properties);

/// Adds the properties of that many names with `values[row * names.size() + i]`.
void set_properties(Element& element, const std::vector<std::string>& names, Value_type type,
                    const std::vector<double>& values);

/// Removes normals of vertices, faces and corners, which are wrong once the points have moved.
/// \returns whether there were any
bool remove_normals(Surface_file& file);

/// What readers do with faces that have fewer than three corners, or a corner twice: `kept` is for
/// those who remove them.
enum class Bad_faces { refused, kept };

/// Describes a fault of a face, or returns an empty string: an index out of [0, n) or, unless they
/// are kept, fewer than three corners or a repeated corner.
/// \param base the offset of indices in the format (OBJ: 1)
std::string fault_of_face(const std::int64_t* begin, const std::int64_t* end, std::size_t n,
                          int base, Bad_faces bad_faces);

/// Appends a face whose indices are in range.
void append_face(Polygons& polygons, const std::int64_t* begin, const std::int64_t* end);

}  // namespace conformal
