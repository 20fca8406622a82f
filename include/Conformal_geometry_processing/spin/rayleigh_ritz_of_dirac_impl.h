// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_RAYLEIGH_RITZ_OF_DIRAC_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_RAYLEIGH_RITZ_OF_DIRAC_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE bool is_surely_unmixed(double gamma, double mu)
{
  return mu - gamma * gamma <= internal::visible_mixture * internal::visible_mixture * mu;
}

CGP_INLINE bool has_mixed_signs(const internal::Dirac_forms& forms)
{
  const auto& S = forms.dirac;
  const double a = S(0, 0).w / forms.mass(0, 0).w, b = S(1, 1).w / forms.mass(1, 1).w;
  const double s = norm(S(0, 1)) / std::sqrt(forms.mass(0, 0).w * forms.mass(1, 1).w);
  const bool are_opposite = a * b < s * s;  // the determinant of the form is negative
  return are_opposite && 2 * s > internal::visible_mixture * std::abs(a - b);
}

CGP_INLINE std::array<double, 2> signed_eigenvalues(const internal::Dirac_forms& forms)
{
  const auto& S = forms.dirac;
  const double a = S(0, 0).w / forms.mass(0, 0).w, b = S(1, 1).w / forms.mass(1, 1).w;
  const double s = norm(S(0, 1)) / std::sqrt(forms.mass(0, 0).w * forms.mass(1, 1).w);
  const double mean = (a + b) / 2, radius = std::hypot((a - b) / 2, s);
  return {mean - radius, mean + radius};
}

CGP_INLINE bool separation_pays(const internal::Dirac_forms& forms)
{
  if (!has_mixed_signs(forms)) return false;
  const auto [a, b] = signed_eigenvalues(forms);
  return 5 * (std::min)(std::abs(a), std::abs(b)) >= (std::max)(std::abs(a), std::abs(b));
}

CGP_INLINE Block<Quaternion<double>> rayleigh_ritz_of_dirac(
    const Block<Quaternion<double>>& vectors, const internal::Dirac_forms& forms)
{
  const auto mass = hermitian_jacobi(forms.mass);
  Block<Quaternion<double>> C = mass.vectors;  // C^H mass C = 1
  for (Eigen::Index j = 0; j < C.cols(); ++j) scale_column(C, j, 1 / std::sqrt(mass.values[j]));
  const auto S = gram_matrix(C, combination(forms.dirac, C));
  return combination(vectors, combination(C, hermitian_jacobi(S).vectors));
}

}  // namespace Conformal_geometry_processing

#endif
