// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/painting/Gray_image.h>

#include <Conformal_geometry_processing/exceptions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
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

}  // namespace Conformal_geometry_processing
