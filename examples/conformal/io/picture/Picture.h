// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// The samples of a picture, row by row from the top: one for each pixel, its gray, or three, its
/// red, green and blue.
class Picture {
 public:
  /// \throws Read_error, before there is memory for it, if a side has more than 32768 pixels or the
  /// picture more than 2^26: a small file may claim more than the machine has
  Picture(const std::string& path, std::uint64_t width, std::uint64_t height, int channels,
          int white);

  std::size_t width() const { return m_width; }
  std::size_t height() const { return m_height; }
  std::size_t samples_per_row() const { return m_width * m_channels; }
  std::size_t samples() const { return m_samples.size(); }

  /// the largest value of a sample: 255, 65535 or what the file says
  int white() const { return m_white; }

  /// the largest one that there is
  int largest() const { return *std::max_element(m_samples.begin(), m_samples.end()); }

  void set(std::size_t i, int value) { m_samples.at(i) = static_cast<std::uint16_t>(value); }

  /// \brief Sets all samples from bytes: one each, or two with the higher one first.
  /// \pre `bytes.size()` is the number of samples, or twice that
  void set_all(std::string_view bytes);

  /// \brief The gray of a pixel, 0 for black and 1 for white; colours count by their luminance. The
  /// same picture with samples of another depth has the same gray, bit for bit.
  double gray(std::size_t row, std::size_t column) const;

 private:
  std::size_t m_width, m_height, m_channels;
  int m_white;
  std::vector<std::uint16_t> m_samples;
};

}  // namespace conformal
