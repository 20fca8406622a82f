// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GRAY_IMAGE_H
#define CONFORMAL_GRAY_IMAGE_H

#include <string>
#include <vector>

namespace conformal {

/// A picture as gray values from 0 (black) to 1 (white), at the middles of its pixels.
class Gray_image {
 public:
  /// \pre `values` has width x height entries, row by row from the top
  Gray_image(int width, int height, std::vector<double> values)
      : m_width(width), m_height(height), m_values(std::move(values))
  {}

  int width() const { return m_width; }
  int height() const { return m_height; }

  /// The value at (u, v) in [0, 1]^2, linear between the middles of pixels; (0, 0) is the lower
  /// left corner, as in texture coordinates. Outside, the picture repeats itself.
  double operator()(double u, double v) const;

 private:
  double pixel(int column, int row) const;

  int m_width, m_height;
  std::vector<double> m_values;
};

/// Reads a PNG, JPEG, PGM or PPM file of 8 or 16 bits; colours become gray by their luminance.
/// \throws Read_error
Gray_image read_gray_image(const std::string& path);

}  // namespace conformal

#endif
