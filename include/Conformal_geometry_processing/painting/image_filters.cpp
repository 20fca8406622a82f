// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/painting/image_filters.h>

#include <Quaternionic_linear_algebra/exceptions.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

Gray_image::Gray_image(Eigen::ArrayXXd pixels) : m_pixels(std::move(pixels))
{
  if (m_pixels.size() == 0)
    throw Precondition_error("Gray_image", "no pixels; at least one is needed");
}

double Gray_image::operator()(double u, double v) const
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

Eigen::VectorXd Gray_image::operator()(const Eigen::Matrix2Xd& places) const
{
  Eigen::VectorXd values(places.cols());
  for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = (*this)(places(0, i), places(1, i));
  return values;
}

double Gray_image::pixel(Eigen::Index row, Eigen::Index column) const
{
  return m_pixels(std::clamp<Eigen::Index>(row, 0, height() - 1),
                  std::clamp<Eigen::Index>(column, 0, width() - 1));
}

namespace internal {

/// Returns the Gaussian with this standard deviation at 0, 1, 2, ..., truncated where the remaining
/// integral is 6e-7.
Eigen::VectorXd gauss_weights(double radius)
{
  const int reach = radius > 0 ? static_cast<int>(std::ceil(5 * radius)) : 0;
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(reach + 1);
  for (int k = 1; k <= reach; ++k) weights[k] = std::exp(-(k / radius) * (k / radius) / 2);
  return weights;
}

/// Replaces every column by the weighted mean of the existing neighbouring columns.
Eigen::ArrayXXd blurred_across(const Eigen::ArrayXXd& pixels, const Eigen::VectorXd& weights)
{
  const Eigen::Index reach = weights.size() - 1, last = pixels.cols() - 1;
  Eigen::ArrayXXd blurred = Eigen::ArrayXXd::Zero(pixels.rows(), pixels.cols());
  for (Eigen::Index c = 0; c <= last; ++c) {
    double sum = 0;
    for (Eigen::Index k = (std::max<Eigen::Index>)(0, c - reach); k <= (std::min)(last, c + reach);
         ++k) {
      const double weight = weights[k < c ? c - k : k - c];
      blurred.col(c) += weight * pixels.col(k);
      sum += weight;
    }
    blurred.col(c) /= sum;
  }
  return blurred;
}

}  // namespace internal

Gray_image blurred(const Gray_image& image, double radius)
{
  if (!(radius >= 0 && radius <= 1e6))
    throw Precondition_error("blurred", "a radius of " + std::to_string(radius) +
                                            " pixels; a number from 0 to 1000000 is needed");
  const Eigen::VectorXd weights = internal::gauss_weights(radius);
  const Eigen::ArrayXXd rows = internal::blurred_across(image.pixels(), weights).transpose();
  return Gray_image(internal::blurred_across(rows, weights).transpose());
}

Gray_image filtered(const Gray_image& image, Curvature_band band, double radius, double amount)
{
  const Eigen::ArrayXXd high = image.pixels() - blurred(image, radius).pixels();
  Eigen::ArrayXXd pixels = band_of(image.pixels(), high, band, amount);
  if (band == Curvature_band::high) pixels += 0.5;
  return Gray_image(std::move(pixels));
}

Curvature_potential painted_curvature(const Gray_image& image, const Eigen::Matrix2Xd& places,
                                      double amplitude)
{
  return Curvature_potential::on_faces(amplitude * (image(places).array() - 0.5));
}

}  // namespace Conformal_geometry_processing
