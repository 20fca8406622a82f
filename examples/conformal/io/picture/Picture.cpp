// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Picture.h"

#include "conformal/io/file/io_errors.h"

namespace conformal {
namespace {

std::size_t checked_side(const std::string& path, std::uint64_t side)
{
  if (side >= 1 && side <= 32768) return static_cast<std::size_t>(side);
  throw Read_error(path, 0,
                   "a picture of " + std::to_string(side) +
                       " pixels in a direction, wanted 1 to 32768; try: a smaller picture");
}

std::size_t checked_pixels(const std::string& path, std::size_t pixels)
{
  const std::size_t most = std::size_t{1} << 26;
  if (pixels <= most) return pixels;
  throw Read_error(path, 0,
                   "a picture of " + std::to_string(pixels) + " pixels, wanted at most " +
                       std::to_string(most) + "; try: a smaller picture");
}

}  // namespace

Picture::Picture(const std::string& path, std::uint64_t width, std::uint64_t height, int channels,
                 int white)
    : m_width(checked_side(path, width)),
      m_height(checked_side(path, height)),
      m_channels(static_cast<std::size_t>(channels)),
      m_white(white),
      m_samples(checked_pixels(path, m_width * m_height) * m_channels)
{}

void Picture::set_all(std::string_view bytes)
{
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const bool is_deep = bytes.size() == 2 * samples();
  for (std::size_t i = 0; i < samples(); ++i)
    set(i, is_deep ? 256 * byte(2 * i) + byte(2 * i + 1) : byte(i));
}

// Divided once: the quotient of equal fractions is the same number, whatever their denominators.
double Picture::gray(std::size_t row, std::size_t column) const
{
  const std::uint16_t* const pixel = m_samples.data() + (row * m_width + column) * m_channels;
  if (m_channels == 1) return double(pixel[0]) / m_white;
  return (299. * pixel[0] + 587. * pixel[1] + 114. * pixel[2]) / (1000. * m_white);
}

}  // namespace conformal
