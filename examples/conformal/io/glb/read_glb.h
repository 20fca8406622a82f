// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <string_view>

namespace conformal {

/// Reads the triangles of the scene of a GLB file, or of a glTF file whose numbers are inside or in
/// files beside it, each mesh in its place. Corners of exactly equal
/// coordinates are one vertex, numbered by first appearance. Texture coordinates are those of
/// corners; colours, and numbers such as `_RHO`, those of vertices. Names of nodes, meshes and
/// materials become lines `g`, `o` and `usemtl`. Normals are not read, since the points define
/// them; all else is `Left_out`. \throws Read_error
Surface_file parse_glb(std::string_view bytes, const std::string& path,
                       Bad_faces bad_faces = Bad_faces::refused);

}  // namespace conformal
