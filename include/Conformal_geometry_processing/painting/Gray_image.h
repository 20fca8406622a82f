// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgPainting
/// \brief A gray-scale image, 0 for black and 1 for white, with values at the centres of its
/// pixels.
class Gray_image {
 public:
  /// \param pixels row by row from the top
  /// \throw Precondition_error if the image is empty
  explicit Gray_image(Eigen::ArrayXXd pixels);

  Eigen::Index width() const { return m_pixels.cols(); }
  Eigen::Index height() const { return m_pixels.rows(); }
  const Eigen::ArrayXXd& pixels() const { return m_pixels; }

  /// \brief Returns the value at (u, v) in [0, 1]^2 by bilinear interpolation between the centres
  /// of pixels, constant near the border; (0, 0) is the lower left corner, as for texture
  /// coordinates.
  ///
  /// The image is repeated periodically outside the square. NaN if a coordinate is not finite.
  double operator()(double u, double v) const;

  /// Returns the values at many positions, one per column
  Eigen::VectorXd operator()(const Eigen::Matrix2Xd& places) const;

 private:
  // Maps t to [0, 1] periodically, except that 1 is the last pixel and not the first one.
  static double repeated(double t) { return t >= 0 && t <= 1 ? t : t - std::floor(t); }

  double pixel(Eigen::Index row, Eigen::Index column) const;

  Eigen::ArrayXXd m_pixels;
};

}  // namespace Conformal_geometry_processing
