// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_IO_PICTURE_READ_PNG_H
#define CONFORMAL_IO_PICTURE_READ_PNG_H

#include "Picture.h"

namespace conformal {

/// \brief Decodes a PNG file of any depth, with the library libpng; transparency is ignored.
/// \throws Read_error
Picture parse_png(std::string_view bytes, const std::string& path);

}  // namespace conformal

#endif
