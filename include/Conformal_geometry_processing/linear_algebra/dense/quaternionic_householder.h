// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_QUATERNIONIC_HOUSEHOLDER_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_QUATERNIONIC_HOUSEHOLDER_H

#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief A = Q T Q^H with Q^H Q = 1 and a *real* symmetric tridiagonal T, for a quaternionic
/// Hermitian matrix A.
struct Quaternionic_tridiagonalization {
  Block<Quaternion<double>> Q;
  Vector<double> diagonal;
  Vector<double> subdiagonal;  ///< not negative; has one entry less
};

// The reflection 1 - v v^H / scale that maps x to a multiple of the first unit vector.
struct Quaternionic_reflection {
  Quaternion_vector<double> v;
  double scale = 0;                      // |v|^2 / 2; zero means the identity
  Quaternion<double> image{0, 0, 0, 0};  // the first entry of the reflected x

  explicit Quaternionic_reflection(const Quaternion_vector<double>& x);
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Tridiagonalizes A by Householder reflections, each of which annihilates a column below
/// the subdiagonal, and by phases that make the subdiagonal real. About 7/3 d^3 quaternionic
/// products.
/// \pre A is Hermitian and finite
internal::Quaternionic_tridiagonalization tridiagonalized(Block<Quaternion<double>> A);

/// \ingroup PkgLinearAlgebra
/// \brief Computes the eigenvalues and eigenvectors of a quaternionic Hermitian matrix. Faster than
/// `hermitian_jacobi()` for matrices of more than some fifty rows.
///
/// The tridiagonal form is real, so the remaining problem is real and has the same size, instead of
/// two or four times that size. A real A has real eigenvectors.
/// \pre A is Hermitian
/// \throw Solver_error if the iteration for the tridiagonal matrix does not converge, for example
/// because of values that are not finite
internal::Hermitian_eigen_decomposition<Quaternion<double>> quaternionic_householder(
    Block<Quaternion<double>> A);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/dense/quaternionic_householder_impl.h>
#endif

#endif
