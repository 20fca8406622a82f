// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>

#include <array>
#include <functional>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

// The search space of the iteration, the span of S = [x, w, p]. All iterations use the same memory.
//
// Only x has N-orthonormal columns. A basis of the span is found among the combinations of S by
// S^H N S: to orthonormalize w and p themselves would read and write each of them many times.
struct Lobpcg_space {
  using Vectors = Block<Quaternion<double>>;

  // S^H N S and S^H K S
  struct Forms {
    Vectors n, k;

    Forms& operator+=(const Forms& other)
    {
      n += other.n;
      k += other.k;
      return *this;
    }
  };

  Ritz_panel x, w, p;  // iterates; preconditioned residuals; previous steps

  std::array<const Ritz_panel*, 3> panels() const { return {&x, &w, &p}; }
  Eigen::Index size() const { return x.size() + w.size() + p.size(); }

  Forms forms() const;
  void advance(const Vectors& C);
};

// Type-erased y = f(x), so that the iteration is compiled once and not for every operator.
using Block_function =
    std::function<void(const Block<Quaternion<double>>&, Block<Quaternion<double>>&)>;

template <class Operator>
Block_function block_function(const Operator& apply)
{
  return [&apply](const Block<Quaternion<double>>& x, Block<Quaternion<double>>& y) {
    apply_operator(apply, x, y);
  };
}

Eigensolver_result lobpcg(const Block_function& apply_k, const Block_function& apply_n,
                          const Block_function& precondition, Block<Quaternion<double>> x0,
                          const Eigensolver_options& options,
                          const std::function<bool(const Eigensolver_progress&)>& go_further);

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes the smallest eigenpairs of K x = N x theta by locally optimal block
/// preconditioned conjugate gradients over the quaternions.
///
/// Every iteration minimizes the Rayleigh quotients over the span of the iterates x, of w = T r
/// (the preconditioned residuals) and of p (the previous steps), with quaternionic coefficients:
/// each eigenvalue occurs once, not four times as in the real form. On a space over the reals only
/// (`Eigensolver_options::coefficients`) the coefficients are real. With T the inverse of K plus a
/// small shift, 3 to 8 iterations reach 1e-6, where the inverse power method needs 4 to 60.
/// Deterministic. Cost per iteration: one T, two K and two N on the block; three K where
/// `Eigensolver_options::adapt` changes the matrix.
///
/// \param apply_k, apply_n, precondition callables that map a `Block<Quaternion<double>>` to one
///   of the same shape: K Hermitian, N Hermitian positive definite, T an approximation of the
///   inverse of K, Hermitian positive definite. See `block_operators.h`.
/// \param x0 the initial vectors; their number is the block size. More columns than wanted
///   accelerate the convergence for close eigenvalues, and yield the gap.
/// \param go_further called with `Eigensolver_progress` before every iteration; false cancels
/// \returns the best iterate; check `converged`
/// \throws Precondition_error if the columns of x0 are dependent, or fewer than wanted
/// \throws Solver_error if an operator returns values that are not finite
template <class K, class N, class T, class GoFurther = internal::Always_go_further>
Eigensolver_result lobpcg(const K& apply_k, const N& apply_n, const T& precondition,
                          Block<Quaternion<double>> x0, const Eigensolver_options& options = {},
                          GoFurther go_further = {})
{
  return internal::lobpcg(internal::block_function(apply_k), internal::block_function(apply_n),
                          internal::block_function(precondition), std::move(x0), options,
                          std::ref(go_further));
}

/// \ingroup PkgLinearAlgebra
/// \brief `lobpcg()` for matrices: the default eigensolver.
/// \cgalModels{SparseHermitianEigensolverTraits}
struct Lobpcg_eigensolver_traits {
  /// \param N the masses, or a Hermitian positive definite matrix
  /// \param solver has factorized A plus a small positive definite shift
  template <class Masses, class Solver, class GoFurther = internal::Always_go_further>
  Eigensolver_result operator()(const Hermitian_sparse_matrix<Quaternion<double>>& A,
                                const Masses& N, const Solver& solver, Block<Quaternion<double>> x0,
                                const Eigensolver_options& options = {},
                                GoFurther go_further = {}) const
  {
    return lobpcg(block_operator(A), block_operator(N), inverse_operator(solver), std::move(x0),
                  options, std::move(go_further));
  }
};

}  // namespace Conformal_geometry_processing
