// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <string_view>

namespace conformal {

/// Reads an STL file, ASCII or binary. Corners of exactly equal coordinates are one vertex (0 and
/// -0 are equal), numbered by first appearance; facet normals are not stored, since the points
/// define them; the 16 bits after a binary facet are stored as the face property `attribute` if one
/// of them is set; names of solids are comments. O(bytes). \throws Read_error
Surface_file read_stl(const std::string& path);

/// the same from memory; `path` is for messages
Surface_file parse_stl(std::string_view bytes, const std::string& path,
                       Bad_faces bad_faces = Bad_faces::refused);

/// Whether the size is the one that the count of a binary STL file announces.
bool is_binary_stl(std::string_view bytes);

}  // namespace conformal
