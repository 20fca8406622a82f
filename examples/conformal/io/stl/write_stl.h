// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

/// The bytes of a binary STL file: triangles with their normals, in single precision; polygons are
/// fans of triangles. The face property `attribute` becomes the 16 bits after a facet.
/// \param notes receives data that the format does not support
std::string encode_stl(const Surface_file& file, std::vector<std::string>& notes);

}  // namespace conformal
