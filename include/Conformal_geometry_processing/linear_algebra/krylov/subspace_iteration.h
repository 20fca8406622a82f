// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Centered_mass.h>

#include <cmath>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// Stopping criteria of `subspace_iteration()`
struct Subspace_options {
  double tolerance = 1e-6;  ///< bound on `Subspace_result::residual`
  int maximum_number_of_iterations = 100;
};

/// \ingroup PkgLinearAlgebra
/// \brief The smallest eigenvalue of a pencil, its eigenvector, and error estimates.
template <class Scalar>
struct Subspace_result {
  Vector<Scalar> vector;  ///< normalized under the mass; its component in the common kernel of the
                          ///< mass and A, the constants, is determined by rounding
  double eigenvalue = 0;  ///< of the vector
  double next_eigenvalue = 0;  ///< an upper bound, sharp if it is well separated
  double residual = HUGE_VAL;  ///< estimated relative error of the previous vector, A-norm
  int iterations = 0;
  bool converged = false;
  Solver_status status = Solver_status::success;  ///< of the solves
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes the smallest eigenvalue of A x = mu B x by inverse subspace iteration with the
/// Rayleigh-Ritz method.
///
/// For k vectors, each step reduces the error by about mu / mu_k, where mu_k is the k-th other
/// eigenvalue, so that double or clustered eigenvalues do not slow down the convergence. One block
/// solve and one product with A per step; deterministic to the bit.
///
/// \param A Hermitian positive semidefinite
/// \param B the mass, of which the weights D are the diagonal part
/// \param solver has factorized A + shift D. A shift by the mass, not by the identity, does not
/// change the eigenvectors.
/// \param x initial vectors, one per column
/// \throw Solver_error if a solution is not finite
template <class Scalar>
internal::Subspace_result<Scalar> subspace_iteration(
    const Hermitian_sparse_matrix<Scalar>& A, const internal::Centered_mass<Scalar>& B,
    double shift, const internal::Solver_ref<Scalar>& solver, Block<Scalar> x,
    const internal::Subspace_options& options = {});

}  // namespace Conformal_geometry_processing
