// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

/// Returns the text of an OFF file, with the prefixes ST, C and N for the vertex properties; all
/// numbers are the shortest ones that read back the same.
/// \param notes receives data that the format does not support (texture coordinates with seams,
/// ...)
std::string encode_off(const Surface_file& file, std::vector<std::string>& notes);

}  // namespace conformal
