// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/krylov/krylov_schur.h>

namespace Conformal_geometry_processing {
namespace internal {

/// \ingroup PkgSpin
/// Eigenvectors of an operator, found as combinations of those of its square
struct Signed_eigenvectors {
  Block<Quaternion<double>> vectors;  ///< M-orthonormal
  Vector<double> residuals;           ///< of the eigenvectors of the square, combined likewise
  /// every eigenvector of the square whose eigenvalue (that of N x = mu M x) is less, is in the
  /// span
  double reach = 0;
};

}  // namespace internal

/// \ingroup PkgSpin
/// \brief separates the eigenvectors of an operator K that its square N has mixed because their
/// eigenvalues differ by the sign only.
///
/// The span of *all* eigenvectors of N with eigenvalues below a bound is invariant under K, and
/// Rayleigh-Ritz of K in it tells the signs. Of a finite number of vectors, the last ones may be
/// mixtures with vectors that are missing: their images N^-1 K v leave the span by about |v| /
/// sqrt(mu), those of all others by the discretisation error. They are left out. Only vectors whose
/// mu differ by less than a factor of two, or whose coupling <v, K w> is too large for an error of
/// discretisation, are combined: others are not mixed.
///
/// Costs one K and one solution for each vector, and some n^2 products of |V| quaternions and n^3.
/// \param form K, and N^-1
/// \param square the eigenpairs of M x = theta N x with the n largest theta > 0
/// \throw Solver_error if an operator returns values that are not finite
internal::Signed_eigenvectors signed_eigenvectors(const internal::Pencil& form,
                                                  const internal::Krylov_result& square);

}  // namespace Conformal_geometry_processing
