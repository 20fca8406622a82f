// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Gray_image.h"

#include "io/io_errors.h"
#include "io/read_bytes.h"

#include <algorithm>
#include <climits>
#include <cmath>
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
namespace {

// t in [0, 1] stays, so that 1 is the last pixel and not the first again
double repeated(double t)
{
  if (!std::isfinite(t)) return 0;
  return t >= 0 && t <= 1 ? t : t - std::floor(t);
}

}  // namespace

double Gray_image::pixel(int column, int row) const
{
  const int c = std::clamp(column, 0, m_width - 1), r = std::clamp(row, 0, m_height - 1);
  return m_values[static_cast<std::size_t>(r) * static_cast<std::size_t>(m_width) +
                  static_cast<std::size_t>(c)];
}

double Gray_image::operator()(double u, double v) const
{
  const double x = repeated(u) * m_width - 0.5, y = (1 - repeated(v)) * m_height - 0.5;
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  const double s = x - column, t = y - row;
  return (1 - t) * ((1 - s) * pixel(column, row) + s * pixel(column + 1, row)) +
         t * ((1 - s) * pixel(column, row + 1) + s * pixel(column + 1, row + 1));
}

Gray_image read_gray_image(const std::string& path)
{
  const std::string bytes = read_bytes(path);
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
  std::vector<double> values(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = pixels.get()[i] / 65535.0;
  return {width, height, std::move(values)};
}

}  // namespace conformal
