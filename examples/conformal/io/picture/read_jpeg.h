// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_IO_PICTURE_READ_JPEG_H
#define CONFORMAL_IO_PICTURE_READ_JPEG_H

#include "Picture.h"

namespace conformal {

/// \brief Decodes a JPEG file of 8 bits, with the library libjpeg. One that is damaged is refused.
/// \throws Read_error
Picture parse_jpeg(std::string_view bytes, const std::string& path);

}  // namespace conformal

#endif
