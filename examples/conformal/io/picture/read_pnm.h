// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_IO_PICTURE_READ_PNM_H
#define CONFORMAL_IO_PICTURE_READ_PNM_H

#include "Picture.h"

namespace conformal {

/// \brief Decodes a PGM or PPM file, binary or plain, of any largest value (up to 65535).
/// \throws Read_error
Picture parse_pnm(std::string_view bytes, const std::string& path);

}  // namespace conformal

#endif
