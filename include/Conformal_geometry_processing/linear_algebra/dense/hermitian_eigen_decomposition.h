// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion.h>
#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief A V = V diag(values) for a Hermitian matrix A, with V^H V = 1 and ascending values.
template <class Scalar>
struct Hermitian_eigen_decomposition {
  Vector<typename Scalar_traits<Scalar>::FT> values;
  Block<Scalar> vectors;
};

/// \brief A = Q T Q^H with Q^H Q = 1 and a *real* symmetric tridiagonal T, for a quaternionic
/// Hermitian matrix A.
struct Quaternionic_tridiagonalization {
  Block<Quaternion<double>> Q;
  Vector<double> diagonal;
  Vector<double> subdiagonal;  ///< not negative; has one entry less
};

/// \brief by reflections, each of which annihilates a column below the subdiagonal, and by phases
/// that make the subdiagonal real. About 7/3 d^3 quaternionic products.
/// \pre A is Hermitian
Quaternionic_tridiagonalization tridiagonalized(Block<Quaternion<double>> A);

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes the eigenvalues and eigenvectors of a dense Hermitian matrix, real, complex or
/// quaternionic, by Eigen's SelfAdjointEigenSolver.
///
/// The eigenvalues act from the right, A v = v theta; theta is real, and v is unique up to a unit
/// scalar on its right. A quaternionic matrix is first made tridiagonal by reflections over the
/// quaternions. Its tridiagonal form is real, so that each eigenvalue occurs once, not in a pair as
/// in the complex form, from which one vector of each pair would have to be selected again; a real
/// A has real eigenvectors. O(d^3); errors of eigenvalues are rounding errors of the norm of A.
///
/// \pre A is Hermitian
/// \throw Solver_error if the iteration for the tridiagonal matrix does not converge, for example
/// because of values that are not finite
/// \tparam Scalar `double`, `std::complex<double>` or `Quaternion<double>`
template <class Scalar>
internal::Hermitian_eigen_decomposition<Scalar> hermitian_eigen_decomposition(Block<Scalar> A);

}  // namespace Conformal_geometry_processing
