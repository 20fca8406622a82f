// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_gray_image.h"

#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/read_bytes.h"

#include <climits>
#include <cstdlib>
#include <memory>

// Only the formats that are asked for: the known holes of the decoder are in the others.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_PNM
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 32768
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace conformal {

CGP::Gray_image read_gray_image(const std::string& path)
{
  const std::string bytes = read_bytes(path, "a picture");
  if (bytes.size() > INT_MAX) throw Read_error(path, 0, "is too large for a picture");
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_us, decltype(&std::free)> pixels(
      stbi_load_16_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                               static_cast<int>(bytes.size()), &width, &height, &channels, 1),
      &std::free);
  if (!pixels)
    throw Read_error(path, 0,
                     std::string("cannot be understood as PNG, JPEG, PGM or PPM picture: ") +
                         stbi_failure_reason());
  const Eigen::Map<const Eigen::Array<stbi_us, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>
      rows(pixels.get(), height, width);
  return CGP::Gray_image(rows.cast<double>() / 65535);
}

}  // namespace conformal
