// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

/// The bytes of a legacy VTK file: binary, of version 3, with coordinates of double precision and
/// the properties of vertices and faces as arrays.
std::string encode_vtk(const Surface_file& file, std::vector<std::string>& notes);

}  // namespace conformal
