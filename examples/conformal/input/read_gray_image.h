// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_INPUT_READ_GRAY_IMAGE_H
#define CONFORMAL_INPUT_READ_GRAY_IMAGE_H

#include <Conformal_geometry_processing/painting/Gray_image.h>

#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Reads a PNG, JPEG, PGM or PPM file of 8 or 16 bits; colours become gray by their luminance.
/// \throws Read_error
CGP::Gray_image read_gray_image(const std::string& path);

}  // namespace conformal

#endif
