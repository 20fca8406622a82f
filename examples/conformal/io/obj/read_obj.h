// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <string_view>

namespace conformal {

/// Reads the polygons of an OBJ file: `v` with colours, `vt`, `vn`, `f` with absolute or relative
/// indices, lines continued by a backslash. `g o s usemtl mtllib` and the like are kept with the
/// face that they precede, comments on lines of their own are kept. All other statements, and
/// attributes that are not as they should be, are `Left_out`. O(bytes). \throws Read_error
Surface_file read_obj(const std::string& path);

/// the same from memory; `path` is for messages
Surface_file parse_obj(std::string_view bytes, const std::string& path,
                       Bad_faces bad_faces = Bad_faces::refused);

}  // namespace conformal
