// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

/// The text of a USD file (`.usda`) with one mesh: points, polygons, texture coordinates of corners
/// as `primvars:st`, normals and colours of vertices, and other numbers of vertices and faces as
/// primvars. No subdivision; y is up. In single precision, as USD has points.
/// \throws Write_error (for `path`) if a coordinate does not fit into a float
std::string encode_usda(const Surface_file& file, const std::string& path,
                        std::vector<std::string>& notes);

}  // namespace conformal
