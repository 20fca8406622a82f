// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <string_view>

namespace conformal {

/// Reads a mesh file of the format that its content shows, or else its extension: OFF, OBJ, PLY,
/// STL, GLB, glTF, or VTK's PolyData. The whole file is held in memory while it is read (16 GiB at
/// most). \throws Read_error, whose message begins with `path:line:` where there are lines
Surface_file read_surface(const std::string& path, Bad_faces bad_faces = Bad_faces::refused);

/// the same from memory; `path` is for messages and for its extension
Surface_file parse_surface(std::string_view bytes, const std::string& path,
                           Bad_faces bad_faces = Bad_faces::refused);

}  // namespace conformal
