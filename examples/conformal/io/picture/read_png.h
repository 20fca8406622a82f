// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Picture.h"

namespace conformal {

/// \brief Decodes a PNG file of any depth, with the library libpng; transparency is ignored.
/// \throws Read_error
Picture parse_png(std::string_view bytes, const std::string& path);

}  // namespace conformal
