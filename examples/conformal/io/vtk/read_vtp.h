// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <string_view>

namespace conformal {

/// Reads the polygons of a VTK file of PolyData as XML (`.vtp`): one piece, with arrays as text or
/// bytes, in base64 or raw, in their places or appended, plain or compressed by zlib. Points, lines
/// and strips are `Left_out`. \throws Read_error
Surface_file parse_vtp(std::string_view bytes, const std::string& path,
                       Bad_faces bad_faces = Bad_faces::refused);

}  // namespace conformal
