// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/painting/image_filters.h>

#include <string>
#include <string_view>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Decodes a PNG, JPEG, PGM or PPM file of any depth; colours become gray by their luminance. One
/// picture has the same gray in every encoding without loss and every depth. \throws Read_error
CGP::Gray_image parse_gray_image(std::string_view bytes, const std::string& path);

/// Likewise, from a file
CGP::Gray_image read_gray_image(const std::string& path);

}  // namespace conformal
