// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_QUATERNIONIC_JACOBI_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_QUATERNIONIC_JACOBI_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief A V = V diag(values) for a Hermitian matrix A, with V^H V = 1 and ascending values.
template <class FT>
struct Quaternionic_eigen_decomposition {
  Vector<FT> values;
  Block<Quaternion<FT>> vectors;
};

namespace internal {

// Turns columns p and q of m into p c - q phase s and p s + q phase c.
template <class FT>
void rotate_columns(Block<Quaternion<FT>>& m, Eigen::Index p, Eigen::Index q, FT c, FT s,
                    const Quaternion<FT>& phase)
{
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    const Quaternion<FT> a = m(i, p), b = m(i, q) * phase;
    m(i, p) = a * c - b * s;
    m(i, q) = a * s + b * c;
  }
}

// The same from the left, by the conjugate transpose.
template <class FT>
void rotate_rows(Block<Quaternion<FT>>& m, Eigen::Index p, Eigen::Index q, FT c, FT s,
                 const Quaternion<FT>& phase)
{
  for (Eigen::Index i = 0; i < m.cols(); ++i) {
    const Quaternion<FT> a = m(p, i), b = conjugate(phase) * m(q, i);
    m(p, i) = a * c - b * s;
    m(q, i) = a * s + b * c;
  }
}

// Makes A_pq vanish: a phase makes it real, a real Jacobi rotation does the rest.
template <class FT>
void annihilate(Block<Quaternion<FT>>& A, Block<Quaternion<FT>>& V, Eigen::Index p, Eigen::Index q)
{
  const FT size = norm(A(p, q));
  if (!(size > 0)) return;
  const Quaternion<FT> phase = conjugate(A(p, q)) / size;
  const FT tau = (A(q, q).w - A(p, p).w) / (2 * size);
  const FT t = (tau >= 0 ? FT(1) : FT(-1)) / (std::abs(tau) + std::hypot(FT(1), tau));
  const FT c = 1 / std::hypot(FT(1), t), s = t * c;
  rotate_columns(A, p, q, c, s, phase);
  rotate_rows(A, p, q, c, s, phase);
  rotate_columns(V, p, q, c, s, phase);
  A(p, q) = A(q, p) = Quaternion<FT>{};
}

template <class FT>
FT off_diagonal_squared_norm(const Block<Quaternion<FT>>& A)
{
  FT sum = 0;
  for (Eigen::Index q = 0; q < A.cols(); ++q)
    for (Eigen::Index p = 0; p < q; ++p) sum += 2 * squared_norm(A(p, q));
  return sum;
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief the eigenvalues and eigenvectors of a small quaternionic Hermitian matrix.
///
/// Cyclic Jacobi over the quaternions: eigenvalues come once, not in the pairs (fours) of the
/// complex (real) form. The vectors act from the right, A v = v theta, so theta is real and v is
/// defined up to a unit quaternion on its right. O(d^3) per sweep, about 6 sweeps.
///
/// \pre A is Hermitian and finite
template <class FT>
Quaternionic_eigen_decomposition<FT> quaternionic_jacobi(Block<Quaternion<FT>> A)
{
  const int max_sweeps = 50;
  const Eigen::Index d = A.rows();
  Block<Quaternion<FT>> V(d, d);
  for (Eigen::Index i = 0; i < d; ++i) V(i, i) = {1, 0, 0, 0};
  FT total = internal::off_diagonal_squared_norm(A);
  for (Eigen::Index i = 0; i < d; ++i) total += squared_norm(A(i, i));
  const FT negligible = std::numeric_limits<FT>::epsilon() * std::numeric_limits<FT>::epsilon();
  for (int sweep = 0; sweep < max_sweeps; ++sweep) {
    if (!(internal::off_diagonal_squared_norm(A) > negligible * total)) break;
    for (Eigen::Index p = 0; p < d; ++p)
      for (Eigen::Index q = p + 1; q < d; ++q) internal::annihilate(A, V, p, q);
  }
  std::vector<Eigen::Index> order(static_cast<std::size_t>(d));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](Eigen::Index i, Eigen::Index j) { return A(i, i).w < A(j, j).w; });
  Quaternionic_eigen_decomposition<FT> result{Vector<FT>(d), Block<Quaternion<FT>>(d, d)};
  for (Eigen::Index i = 0; i < d; ++i) {
    const Eigen::Index from = order[static_cast<std::size_t>(i)];
    result.values[i] = A(from, from).w;
    result.vectors.col(i) = V.col(from);
  }
  return result;
}

}  // namespace Conformal_geometry_processing

#endif
