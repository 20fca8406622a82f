// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Computes the smallest eigenpair of K x = N x theta by the inverse power method,
/// K x_i = N x_(i-1) followed by normalization [CGP 5.5, Algorithm 1].
///
/// The step is written as x - K^-1 r, with the residual r = K x - N x theta of x: it has the
/// direction of K^-1 N x, but its fixed points are eigenvectors for an inexact inverse, too.
///
/// For the reproduction of published results; `lobpcg()` converges faster. The mass matrix on the
/// right-hand side, which is missing in the printed algorithm, makes it solve the generalized
/// problem. Converges by the factor theta_1 / theta_2 per iteration. Tolerance 0 gives the fixed
/// number `options.max_iterations`. With several columns, the basis is orthonormalized after
/// every step. One solve per iteration, which the error estimate needs as well.
///
/// \param invert maps b to the solution of K x = b, exactly or nearly so; for other parameters and
/// errors see `lobpcg()`
template <class K, class N, class T, class GoFurther = internal::Always_go_further>
Eigensolver_result inverse_power_method(const K& apply_k, const N& apply_n, const T& invert,
                                        Block<Quaternion<double>> x0,
                                        const Eigensolver_options& options = {},
                                        GoFurther go_further = {})
{
  const internal::Thread_team team;
  internal::Eigensolver_convergence convergence("inverse_power_method", options, x0);
  internal::Ritz_panel x =
      convergence.initial(make_panel(apply_k, apply_n, std::move(x0), options.coefficients));
  Block<Quaternion<double>> r, Tr;
  while (true) {
    x.residual(r);
    apply_operator(invert, r, Tr);
    convergence.count_solve();
    if (convergence.is_last(x, r, Tr, go_further)) break;
    const Eigen::Index columns = x.size();
    x.v -= Tr;
    apply_operators(apply_k, apply_n, x);
    orthonormalize(x);
    if (x.size() < columns) {
      convergence.stop();
      break;
    }
    convergence.count_iteration();
  }
  return convergence.result();
}

/// \ingroup PkgLinearAlgebra
/// \brief `inverse_power_method()` for matrices.
/// \cgalModels{SparseHermitianEigensolverTraits}
struct Inverse_power_eigensolver_traits {
  /// \param N the masses, or a Hermitian positive definite matrix
  /// \param solver has factorized A plus a small positive definite shift
  template <class Masses, class Solver, class GoFurther = internal::Always_go_further>
  Eigensolver_result operator()(const Hermitian_sparse_matrix<Quaternion<double>>& A,
                                const Masses& N, const Solver& solver, Block<Quaternion<double>> x0,
                                const Eigensolver_options& options = {},
                                GoFurther go_further = {}) const
  {
    return inverse_power_method(block_operator(A), block_operator(N), inverse_operator(solver),
                                std::move(x0), options, std::move(go_further));
  }
};

}  // namespace Conformal_geometry_processing
