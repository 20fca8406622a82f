// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PAINTING_GRAY_IMAGE_H
#define CONFORMAL_GEOMETRY_PROCESSING_PAINTING_GRAY_IMAGE_H

#include <Conformal_geometry_processing/exceptions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgPainting
/// \brief a picture of gray values, 0 for black and 1 for white, at the middles of its pixels.
class Gray_image {
 public:
  /// \param pixels row by row from the top
  /// \throw Precondition_error if there are none
  explicit Gray_image(Eigen::ArrayXXd pixels) : m_pixels(std::move(pixels))
  {
    if (m_pixels.size() == 0)
      throw Precondition_error("Gray_image", "no pixels; at least one is needed");
  }

  Eigen::Index width() const { return m_pixels.cols(); }
  Eigen::Index height() const { return m_pixels.rows(); }
  const Eigen::ArrayXXd& pixels() const { return m_pixels; }

  /// \brief the value at (u, v) in [0, 1]^2, linear between the middles of pixels and constant
  /// beyond the outermost ones; (0, 0) is the lower left corner, as of texture coordinates.
  ///
  /// Outside of the square the picture repeats itself. No number where a coordinate is not finite.
  double operator()(double u, double v) const
  {
    if (!std::isfinite(u) || !std::isfinite(v)) return std::numeric_limits<double>::quiet_NaN();
    const double x = repeated(u) * static_cast<double>(width()) - 0.5;
    const double y = (1 - repeated(v)) * static_cast<double>(height()) - 0.5;
    const auto column = static_cast<Eigen::Index>(std::floor(x));
    const auto row = static_cast<Eigen::Index>(std::floor(y));
    const double s = x - static_cast<double>(column), t = y - static_cast<double>(row);
    return (1 - t) * ((1 - s) * pixel(row, column) + s * pixel(row, column + 1)) +
           t * ((1 - s) * pixel(row + 1, column) + s * pixel(row + 1, column + 1));
  }

  /// the values at many places, one per column
  Eigen::VectorXd operator()(const Eigen::Matrix2Xd& places) const
  {
    Eigen::VectorXd values(places.cols());
    for (Eigen::Index i = 0; i < values.size(); ++i)
      values[i] = (*this)(places(0, i), places(1, i));
    return values;
  }

 private:
  // What is in [0, 1] stays, so that 1 is the last pixel and not the first again.
  static double repeated(double t) { return t >= 0 && t <= 1 ? t : t - std::floor(t); }

  double pixel(Eigen::Index row, Eigen::Index column) const
  {
    return m_pixels(std::clamp<Eigen::Index>(row, 0, height() - 1),
                    std::clamp<Eigen::Index>(column, 0, width() - 1));
  }

  Eigen::ArrayXXd m_pixels;
};

}  // namespace Conformal_geometry_processing

#endif
