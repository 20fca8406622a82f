// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <string_view>

namespace conformal {

/// Reads a PLY file, ASCII or binary of either byte order. Every property of every element is kept
/// in its own type. Faces are the list `vertex_indices` or `vertex_index` of the element `face`, or
/// else the strips of the element `tristrips`. O(bytes). \throws Read_error
Surface_file read_ply(const std::string& path);

/// the same from memory; `path` is for messages
Surface_file parse_ply(std::string_view bytes, const std::string& path,
                       Bad_faces bad_faces = Bad_faces::refused);

}  // namespace conformal
