// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

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

/// \ingroup PkgPainting
/// \brief Frequency band selected by a filter, for functions on an image or on a surface whose high
/// frequencies are known [CGP 6.2]
enum class Curvature_band {
  low,     ///< low-pass: keeps the large features
  high,    ///< high-pass: keeps the small features
  unsharp  ///< adds a multiple of the high frequencies: emphasizes the small features
};

/// \ingroup PkgPainting
/// \brief Returns the band of a function.
/// \param values a vector or an array
/// \param high its high frequencies
/// \param amount of `Curvature_band::unsharp`
template <class Values>
Values band_of(const Values& values, const Values& high, Curvature_band band, double amount = 1)
{
  if (band == Curvature_band::low) return values - high;
  if (band == Curvature_band::high) return high;
  return values + amount * high;
}

/// \ingroup PkgPainting
/// \brief Returns G * g, a Gaussian blur: every pixel becomes a weighted mean of its neighbours.
///
/// At the border the weights are normalized over the existing pixels, so constant images are
/// preserved. O(pixels x radius).
/// \param radius the standard deviation in pixels; 0 changes
/// nothing
/// \throw Precondition_error if it is negative, not finite, or more than a million
Gray_image blurred(const Gray_image& image, double radius);

/// \ingroup PkgPainting
/// \brief Applies a standard image filter [CGP 6.2]: low-pass G * g, high-pass 1/2 + g - G * g,
/// which is gray for constant images, or unsharp mask g + amount (g - G * g). Values may leave
/// [0, 1].
/// \param radius the standard deviation of the Gaussian G in pixels
/// \throw Precondition_error as `blurred()`
Gray_image filtered(const Gray_image& image, Curvature_band band, double radius, double amount = 1);

/// \ingroup PkgPainting
/// Returns, for each of |F| faces, the mean over its three corners of columns given at vertices:
/// centroids for positions, their texture coordinates for texture coordinates
template <int Rows>
Eigen::Matrix<double, Rows, Eigen::Dynamic> means_of_corners(
    const Mesh_view& mesh, const Eigen::Matrix<double, Rows, Eigen::Dynamic>& at_vertices)
{
  Eigen::Matrix<double, Rows, Eigen::Dynamic> means(at_vertices.rows(), mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    means.col(f) = (at_vertices.col(v[0]) + at_vertices.col(v[1]) + at_vertices.col(v[2])) / 3;
  }
  return means;
}

/// \ingroup PkgPainting
/// \brief Converts an image to rho [CGP 6.2]: amplitude (g - 1/2) on the faces, so that gray
/// changes nothing and bright areas bulge along the normals.
/// \param places (u, v) of the centre of each face in the image, 2 x |F|
/// \param amplitude in 1/length
Curvature_potential painted_curvature(const Gray_image& image, const Eigen::Matrix2Xd& places,
                                      double amplitude = 1);

}  // namespace Conformal_geometry_processing
