// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// \brief Requires that the bytes of a file, read again, are the surface that was meant: the same
/// faces, whose corners are where they were, bit for bit. In GLB and STL, faces are triangles, and
/// corners are rounded to single precision; they may move by a millionth of the bounding box.
///
/// \param notes receives how many faces are distorted by this rounding
/// \throws Write_error for `path`
void require_written(const std::string& path, const Surface_file& meant, std::string_view bytes,
                     std::vector<std::string>& notes,
                     Value_type coordinates_of_ply = Value_type::float64);

}  // namespace conformal
