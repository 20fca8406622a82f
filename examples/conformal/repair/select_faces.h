// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <vector>

namespace conformal {

/// \brief Faces derived from those of a file, in their order; faces may be removed or divided.
struct Selected_faces {
  Polygons polygons;
  std::vector<int> texture, normals;  ///< rows of the file's tables, per corner; read if it has any
  std::vector<int> face_in_file;      ///< whose properties each face has; ascending
};

/// Appends a face whose corners are corners of the file.
/// \param corners their positions in `file.polygons.corners`
void append(Selected_faces& faces, const Surface_file& file, int face_in_file,
            const std::vector<std::size_t>& corners);

/// Puts them in the place of the faces of the file, with the properties and group lines of those
/// they come from.
void select_faces(Surface_file& file, Selected_faces faces);

/// Keeps these vertices only, in this order, some perhaps twice; the corners have the old numbers.
void select_vertices(Surface_file& file, const std::vector<int>& kept);

/// the vertices of some faces, ascending
std::vector<int> vertices_of(const Surface_file& file, const std::vector<int>& faces);

/// \brief The part of a file that consists of some faces and their vertices. All keep their order,
/// properties, and values at corners.
/// \param faces ascending
Surface_file part_of(const Surface_file& file, const std::vector<int>& faces);

}  // namespace conformal
