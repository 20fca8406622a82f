// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

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

namespace internal {

// Replaces columns p and q of m by p c - q phase s and p s + q phase c.
template <class Scalar, class FT>
void rotate_columns(Block<Scalar>& m, Eigen::Index p, Eigen::Index q, FT c, FT s,
                    const Scalar& phase)
{
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    const Scalar a = m(i, p), b = m(i, q) * phase;
    m(i, p) = a * c - b * s;
    m(i, q) = a * s + b * c;
  }
}

// Applies the conjugate transpose of the rotation from the left.
template <class Scalar, class FT>
void rotate_rows(Block<Scalar>& m, Eigen::Index p, Eigen::Index q, FT c, FT s, const Scalar& phase)
{
  for (Eigen::Index i = 0; i < m.cols(); ++i) {
    const Scalar a = m(p, i), b = conjugate(phase) * m(q, i);
    m(p, i) = a * c - b * s;
    m(q, i) = a * s + b * c;
  }
}

// Annihilates A_pq by a phase, which makes it real, and a real Jacobi rotation.
template <class Scalar>
void annihilate(Block<Scalar>& A, Block<Scalar>& V, Eigen::Index p, Eigen::Index q)
{
  using Traits = Scalar_traits<Scalar>;
  using FT = typename Traits::FT;
  const FT size = std::sqrt(Traits::real(A(p, q) * conjugate(A(p, q))));
  if (!(size > 0)) return;
  const Scalar phase = conjugate(A(p, q)) / size;
  const FT tau = (Traits::real(A(q, q)) - Traits::real(A(p, p))) / (2 * size);
  const FT t = (tau >= 0 ? FT(1) : FT(-1)) / (std::abs(tau) + std::hypot(FT(1), tau));
  const FT c = 1 / std::hypot(FT(1), t), s = t * c;
  rotate_columns(A, p, q, c, s, phase);
  rotate_rows(A, p, q, c, s, phase);
  rotate_columns(V, p, q, c, s, phase);
  A(p, q) = A(q, p) = Scalar{};
}

template <class Scalar>
typename Scalar_traits<Scalar>::FT off_diagonal_squared_norm(const Block<Scalar>& A)
{
  typename Scalar_traits<Scalar>::FT sum = 0;
  for (Eigen::Index q = 0; q < A.cols(); ++q)
    for (Eigen::Index p = 0; p < q; ++p)
      sum += 2 * Scalar_traits<Scalar>::real(A(p, q) * conjugate(A(p, q)));
  return sum;
}

// Sorts the diagonal in ascending order, together with the columns of V.
template <class Scalar>
Hermitian_eigen_decomposition<Scalar> sorted_decomposition(const Block<Scalar>& A,
                                                           const Block<Scalar>& V)
{
  using Traits = Scalar_traits<Scalar>;
  const Eigen::Index d = A.rows();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(d));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
    return Traits::real(A(i, i)) < Traits::real(A(j, j));
  });
  Hermitian_eigen_decomposition<Scalar> result{Vector<typename Traits::FT>(d), Block<Scalar>(d, d)};
  for (Eigen::Index i = 0; i < d; ++i) {
    const Eigen::Index from = order[static_cast<std::size_t>(i)];
    result.values[i] = Traits::real(A(from, from));
    result.vectors.col(i) = V.col(from);
  }
  return result;
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes the eigenvalues and eigenvectors of a Hermitian matrix of a few rows, real,
/// complex or quaternionic, by cyclic Jacobi rotations.
///
/// Of a graded matrix, small eigenvalues keep as many digits as large ones. The Rayleigh-Ritz
/// method of `lobpcg()` needs that: its search directions have energies that are many powers of ten
/// larger than that of the vector that it looks for. With `hermitian_eigen_decomposition()`, whose
/// errors are relative to the norm, it ends at errors of 1e-7. For more than some ten rows, that is
/// faster.
///
/// The eigenvalues act from the right, A v = v theta. O(d^3) per sweep, about 6 sweeps.
///
/// \pre A is Hermitian and finite
template <class Scalar>
internal::Hermitian_eigen_decomposition<Scalar> hermitian_jacobi(Block<Scalar> A)
{
  using Traits = internal::Scalar_traits<Scalar>;
  using FT = typename Traits::FT;
  const int max_sweeps = 50;
  const Eigen::Index d = A.rows();
  Block<Scalar> V = Block<Scalar>::Constant(d, d, Scalar{});
  for (Eigen::Index i = 0; i < d; ++i) V(i, i) = Traits::from_real(1);
  FT total = internal::off_diagonal_squared_norm(A);
  for (Eigen::Index i = 0; i < d; ++i) total += Traits::real(A(i, i) * conjugate(A(i, i)));
  const FT negligible = std::numeric_limits<FT>::epsilon() * std::numeric_limits<FT>::epsilon();
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    if (!(internal::off_diagonal_squared_norm(A) > negligible * total)) break;
    for (Eigen::Index p = 0; p < d; ++p)
      for (Eigen::Index q = p + 1; q < d; ++q) internal::annihilate(A, V, p, q);
  }
  return internal::sorted_decomposition(A, V);
}

}  // namespace Conformal_geometry_processing
