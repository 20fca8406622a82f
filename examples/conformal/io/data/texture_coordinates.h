// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Surface_file.h"

#include <array>
#include <optional>
#include <vector>

namespace conformal {

/// The texture coordinates of the corners, wherever the file has them: `vt` of OBJ, the list
/// `texcoord` of the faces, or `texture_u texture_v`, `s t` or `u v` of the vertices. Empty if
/// there are none.
Corner_values texture_coordinates(const Surface_file& file);

/// The names of the properties that it takes: one of the faces, two of the vertices, or none.
std::vector<std::string> texture_properties(const Surface_file& file);

/// Replaces all texture coordinates, one row per vertex or with seams; empty ones remove them.
/// \pre `values.index` has one entry for every corner
void set_texture_coordinates(Surface_file& file, Corner_values values);
void set_texture_coordinates(Surface_file& file, const std::vector<std::array<double, 2>>& values);

/// Moves texture coordinates from a list of the faces to the corners, where they can change places
/// with them; leaves others where they are.
void list_to_corners(Surface_file& file);

/// The values of the corners as values of the vertices (zero where no face is), or nothing if they
/// jump at a vertex (a seam) or are not given at all corners.
std::optional<std::vector<std::array<double, 3>>> vertex_values(const Surface_file& file,
                                                                const Corner_values& values);

}  // namespace conformal
