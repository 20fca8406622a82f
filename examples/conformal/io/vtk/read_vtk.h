// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <string_view>

namespace conformal {

/// Reads the polygons of a legacy VTK file (`.vtk`) with a dataset POLYDATA, as text or binary, of
/// the versions 1 to 5; points, lines, strips and fields of the whole are `Left_out`.
/// \throws Read_error
Surface_file parse_vtk(std::string_view bytes, const std::string& path,
                       Bad_faces bad_faces = Bad_faces::refused);

}  // namespace conformal
