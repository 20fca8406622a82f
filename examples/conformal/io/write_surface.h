// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"
#include "conformal/io/ply/write_ply.h"

#include <string>
#include <vector>

namespace conformal {

/// The format that `write_surface` will use, by the extension: PLY, OFF, OBJ or GLB.
/// \throws Write_error for any other, so that a program can refuse before it computes
File_format output_format(const std::string& path);

/// Writes a mesh file in the format of its extension; vertices and faces keep their order. Either
/// the whole file appears or the old one stays; `path` may be the input file. The bytes are read
/// again and compared with the surface before they appear (`require_written()`).
/// \return the notes of `file`, and data that the format does not support, one line each. \throws
/// Write_error
std::vector<std::string> write_surface(const std::string& path, const Surface_file& file,
                                       const Ply_style& style = {});

}  // namespace conformal
