// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief The quadratic form D - D C C^H D, which ignores some directions of x: D >= 0 is diagonal,
/// and the columns of C are D-orthonormal.
///
/// If C contains the constants, the form measures the variance of x, independently of its mean.
/// Positive semidefinite.
/// \tparam Scalar_ `double` or `std::complex<double>`
template <class Scalar_>
class Centered_mass {
 public:
  using Scalar = Scalar_;
  using FT = typename Scalar_traits<Scalar>::FT;

  /// \param weights the diagonal of D
  /// \param directions need not be normalized
  /// \pre the columns of `directions` are orthogonal under the weights, and not zero
  Centered_mass(const Vector<FT>& weights, Block<Scalar> directions)
      : m_weights(weights.template cast<Scalar>()), m_directions(std::move(directions))
  {
    for (Eigen::Index k = 0; k < m_directions.cols(); ++k) {
      auto c = m_directions.col(k);
      c /= Scalar(std::sqrt(weights.dot(c.cwiseAbs2())));
    }
  }

  /// Diagonal of D
  const Vector<Scalar>& weights() const { return m_weights; }

  /// D x - D C C^H D x, column by column
  Block<Scalar> operator*(const Block<Scalar>& x) const
  {
    Block<Scalar> y = m_weights.asDiagonal() * x;
    const Block<Scalar> along = m_directions.adjoint() * y;
    y -= m_weights.asDiagonal() * (m_directions * along);
    return y;
  }

  /// Makes the columns of x orthonormal by the Gram-Schmidt process
  /// \pre they are linearly independent with respect to this form
  void orthonormalize(Block<Scalar>& x) const
  {
    for (Eigen::Index k = 0; k < x.cols(); ++k)
      for (int pass = 0; pass < 2; ++pass) {  // the second pass reduces rounding errors
        const Vector<Scalar> y = *this * x.col(k);
        const Vector<Scalar> along = x.leftCols(k).adjoint() * y;
        x.col(k) -= x.leftCols(k) * along;
        const Vector<Scalar> rest = *this * x.col(k);
        x.col(k) /= Scalar(std::sqrt(Scalar_traits<Scalar>::real(x.col(k).dot(rest))));
      }
  }

 private:
  Vector<Scalar> m_weights;
  Block<Scalar> m_directions;
};

/// Stopping criteria of `subspace_iteration()`
struct Subspace_options {
  double tolerance = 1e-6;  ///< bound on `Subspace_result::residual`
  int maximum_number_of_iterations = 100;
};

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
