// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Picture.h"

namespace conformal {

/// \brief Decodes a JPEG file of 8 bits, with the library libjpeg. One that is damaged is refused.
/// \throws Read_error
Picture parse_jpeg(std::string_view bytes, const std::string& path);

}  // namespace conformal
