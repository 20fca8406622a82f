// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_SUBSPACE_ITERATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_SUBSPACE_ITERATION_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Centered_mass.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <Eigen/Core>

#include <algorithm>
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
template <class Solver, class Scalar>
internal::Subspace_result<Scalar> subspace_iteration(const Hermitian_sparse_matrix<Scalar>& A,
                                                     const internal::Centered_mass<Scalar>& B,
                                                     double shift, const Solver& solver,
                                                     Block<Scalar> x,
                                                     const internal::Subspace_options& options = {})
{
  const internal::Thread_team team;
  internal::Subspace_result<Scalar> result;
  B.orthonormalize(x);
  while (result.iterations < options.maximum_number_of_iterations && !result.converged) {
    const Block<Scalar> b = B * x;
    Block<Scalar> y;
    result.status = solver.solve(b, y);
    if (result.status != Solver_status::success) return result;
    const Block<Scalar> H = b.adjoint() * y;
    const auto ritz = hermitian_eigen_decomposition<Scalar>((H + H.adjoint()) / Scalar(2));
    const auto inverses = ritz.values.reverse();
    const Block<Scalar> turn = ritz.vectors.rowwise().reverse();
    if (!(inverses[0] > 0)) {
      result.status = Solver_status::numerical_issue;
      return result;
    }
    const double mu = 1 / inverses[0];
    const Vector<Scalar> v = x * turn.col(0), correction = mu * (y * turn.col(0)) - v;
    const Vector<Scalar> defect =
        mu * (b * turn.col(0)) - A * v - Scalar(shift) * B.weights().cwiseProduct(v);
    // |correction|^2 in the norm of A + shift D, relative to that of v
    const double error = internal::Scalar_traits<Scalar>::real(correction.dot(defect)) / mu;
    x = y * turn;
    B.orthonormalize(x);
    ++result.iterations;
    result.vector = x.col(0);
    result.eigenvalue = mu - shift;
    result.next_eigenvalue = inverses.size() > 1 ? 1 / inverses[1] - shift : HUGE_VAL;
    result.residual = std::sqrt((std::max)(0., error));
    result.converged = result.residual <= options.tolerance;
  }
  return result;
}

}  // namespace Conformal_geometry_processing

#endif
