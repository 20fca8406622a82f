// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PAINTING_GRAY_IMAGE_H
#define CONFORMAL_GEOMETRY_PROCESSING_PAINTING_GRAY_IMAGE_H

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgPainting
/// \brief a picture of gray values, 0 for black and 1 for white, at the middles of its pixels.
class Gray_image {
 public:
  /// \param pixels row by row from the top
  /// \throw Precondition_error if there are none
  explicit Gray_image(Eigen::ArrayXXd pixels);

  Eigen::Index width() const { return m_pixels.cols(); }
  Eigen::Index height() const { return m_pixels.rows(); }
  const Eigen::ArrayXXd& pixels() const { return m_pixels; }

  /// \brief the value at (u, v) in [0, 1]^2, linear between the middles of pixels and constant
  /// beyond the outermost ones; (0, 0) is the lower left corner, as of texture coordinates.
  ///
  /// Outside of the square the picture repeats itself. No number where a coordinate is not finite.
  double operator()(double u, double v) const;

  /// the values at many places, one per column
  Eigen::VectorXd operator()(const Eigen::Matrix2Xd& places) const;

 private:
  // What is in [0, 1] stays, so that 1 is the last pixel and not the first again.
  static double repeated(double t) { return t >= 0 && t <= 1 ? t : t - std::floor(t); }

  double pixel(Eigen::Index row, Eigen::Index column) const;

  Eigen::ArrayXXd m_pixels;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/painting/Gray_image_impl.h>
#endif

#endif
