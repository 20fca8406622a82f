// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

/// The text of an OBJ file: all `v` (with colours of 0..1), `vt`, `vn`, then `f` between the lines
/// of groups and materials; all numbers are the shortest ones that read back the same.
/// \param notes receives data that the format does not support
std::string encode_obj(const Surface_file& file, std::vector<std::string>& notes);

}  // namespace conformal
