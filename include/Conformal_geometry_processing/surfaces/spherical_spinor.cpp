// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/spherical_spinor.h>

#include <Conformal_geometry_processing/algebra/spherical_harmonic.h>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <string>

namespace Conformal_geometry_processing {

void require_spherical_spinor(int kappa, int s, const std::string& function)
{
  if (kappa == 0) throw Precondition_error(function, "kappa is zero; any other integer is wanted");
  if (s < -std::abs(kappa) || s >= std::abs(kappa))
    throw Precondition_error(function, "s is " + std::to_string(s) + "; wanted " +
                                           std::to_string(-std::abs(kappa)) + " to " +
                                           std::to_string(std::abs(kappa) - 1) + " for kappa " +
                                           std::to_string(kappa));
}

Quaternion<double> spherical_spinor(int kappa, int s, const Eigen::Vector3d& point)
{
  const int l = kappa > 0 ? kappa : -kappa - 1;
  const double sign = kappa > 0 ? -1 : 1;
  // mu - 1/2 = s, mu + 1/2 = s + 1
  const double a = sign * std::sqrt((kappa - s) / (2. * kappa + 1));
  const double b = std::sqrt((kappa + s + 1) / (2. * kappa + 1));
  const std::complex<double> psi_1 = a * spherical_harmonic(l, s, point);
  const std::complex<double> psi_2 = b * spherical_harmonic(l, s + 1, point);
  return {psi_2.real(), -psi_1.imag(), -psi_1.real(), psi_2.imag()};
}

}  // namespace Conformal_geometry_processing
