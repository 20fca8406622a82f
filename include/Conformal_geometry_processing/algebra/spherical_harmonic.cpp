// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/algebra/spherical_harmonic.h>

#include <Conformal_geometry_processing/algebra/stable_norm.h>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <cstdlib>

namespace Conformal_geometry_processing {
namespace internal {

double normalized_legendre(int l, int m, double cosine, double sine)
{
  const double pi = std::acos(-1.);
  double value = std::sqrt((2 * m + 1) / (4 * pi));
  for (int i = 1; i <= m; ++i) value *= -sine * std::sqrt((2. * i - 1) / (2. * i));
  double before = 0;
  for (int n = m + 1; n <= l; ++n) {
    const double a = std::sqrt((4. * n * n - 1) / (n * n - m * m));
    const double b = std::sqrt(((n - 1.) * (n - 1) - m * m) / (4. * (n - 1) * (n - 1) - 1));
    const double next = a * (cosine * value - b * before);
    before = value;
    value = next;
  }
  return value;
}

}  // namespace internal

std::complex<double> spherical_harmonic(int l, int m, const Eigen::Vector3d& point)
{
  const int order = std::abs(m);
  if (order > l) return 0;
  const Eigen::Vector3d p = stable_normalized(point);
  const double sine = std::hypot(p.x(), p.y());
  const double longitude = std::atan2(p.y(), p.x());
  const double size = internal::normalized_legendre(l, order, p.z(), sine);
  const std::complex<double> Y = std::polar(1., order * longitude) * size;
  if (m >= 0) return Y;
  return order % 2 == 0 ? std::conj(Y) : -std::conj(Y);
}

}  // namespace Conformal_geometry_processing
