// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <cmath>

#include "quaternionic_linear_algebra/hermitian_matrices.h"

namespace cgp_test {

/// A minimal model of the concept SparseHermitianEigensolverTraits: dense, without support of mass
/// matrices, ignores the solver and the initial vectors.
struct Sparse_hermitian_eigensolver_archetype {
  template <class Solver, class GoFurther = CGP::internal::Always_go_further>
  CGP::Eigensolver_result operator()(const CGP::Hermitian_sparse_matrix<Quaternion<double>>& A,
                                     const CGP::Vector<double>& masses, const Solver&,
                                     const CGP::Block<Quaternion<double>>& x0,
                                     const CGP::Eigensolver_options& options = {},
                                     GoFurther go_further = {}) const
  {
    const int n = A.size();
    CGP::Block<Quaternion<double>> D(n, n);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) D(i, j) = A.coefficient(i, j) / std::sqrt(masses[i] * masses[j]);
    const auto decomposition = CGP::hermitian_eigen_decomposition(D);

    CGP::Eigensolver_result result;
    result.cancelled = !go_further(CGP::Eigensolver_progress{0, decomposition.values[0], 0});
    result.converged = !result.cancelled && options.wanted <= x0.cols();
    result.values = decomposition.values.head(x0.cols());
    result.estimates = CGP::Vector<double>::Zero(x0.cols());
    result.vectors = decomposition.vectors.leftCols(x0.cols());
    for (int j = 0; j < x0.cols(); ++j)
      for (int i = 0; i < n; ++i) result.vectors(i, j) *= 1 / std::sqrt(masses[i]);
    return result;
  }
};

}  // namespace cgp_test
