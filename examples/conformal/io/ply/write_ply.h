// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Ply_header.h"

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

/// The bytes of a PLY file: x, y, z (always of type double, so that no coordinate is rounded), then
/// the properties in their order and types, `vertex_indices` first for faces, then other elements.
///
/// Data from an OFF or OBJ file get the types that viewers expect: normals and texture coordinates
/// float, colours of 0..1 uchar. OBJ texture coordinates become `texture_u texture_v` or, if they
/// have seams, the list `texcoord` of the faces.
/// \param notes receives data that the format does not support
std::string encode_ply(const Surface_file& file, Ply_encoding encoding,
                       std::vector<std::string>& notes);

}  // namespace conformal
