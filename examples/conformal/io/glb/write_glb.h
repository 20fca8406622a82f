// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

/// The bytes of a GLB 2.0 file to look at: POSITION (float, about the middle of the bounding box,
/// which is the translation of the node), NORMAL (of the vertices, or else averaged from the
/// faces), TEXCOORD_0, COLOR_0, other numbers of vertices as `_RHO` and the like, uint32 triangles
/// (polygons as fans).
///
/// Vertex v of the file is vertex v of the GLB; copies for seams come after all vertices. Texture
/// coordinates without colours get a checkerboard. GLB counts v downwards: it is written as 1 - v.
/// \throws Write_error (for `path`) if the file would be larger than 4 GiB, the format's limit, or
/// a coordinate does not fit into a float
std::string encode_glb(const Surface_file& file, const std::string& path,
                       std::vector<std::string>& notes);

/// The same as a glTF 2.0 file: text, with the numbers in base64
std::string encode_gltf(const Surface_file& file, const std::string& path,
                        std::vector<std::string>& notes);

}  // namespace conformal
