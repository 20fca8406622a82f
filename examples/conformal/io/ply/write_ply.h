// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Ply_header.h"

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

struct Ply_style {
  Ply_encoding encoding = Ply_encoding::little_endian;
  Value_type coordinates = Value_type::float64;  ///< so that none is rounded; or float32
};

/// The bytes of a PLY file: x, y, z, then the properties in their order and types, `vertex_indices`
/// first for faces, then other elements.
///
/// Data from an OFF or OBJ file get the types that viewers expect: normals and texture coordinates
/// float, colours of 0..1 uchar. OBJ texture coordinates become `texture_u texture_v` or, if they
/// have seams, the list `texcoord` of the faces.
/// \param notes receives data that the format does not support
std::string encode_ply(const Surface_file& file, const Ply_style& style,
                       std::vector<std::string>& notes);

}  // namespace conformal
