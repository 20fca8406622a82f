// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Picture.h"

namespace conformal {

/// \brief Decodes a PGM or PPM file, binary or plain, of any largest value (up to 65535).
/// \throws Read_error
Picture parse_pnm(std::string_view bytes, const std::string& path);

}  // namespace conformal
