// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_RAYLEIGH_RITZ_OF_DIRAC_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_RAYLEIGH_RITZ_OF_DIRAC_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

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
