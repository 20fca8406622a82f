// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_QUATERNIONIC_HOUSEHOLDER_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_QUATERNIONIC_HOUSEHOLDER_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>
#include <Conformal_geometry_processing/linear_algebra/dense/quaternionic_householder.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE Quaternionic_reflection::Quaternionic_reflection(const Quaternion_vector<double>& x)
    : v(x)
{
  const double length = std::sqrt(inner_product(x, x).w), first = norm(x[0]);
  image = x[0];
  if (!(length > first)) return;
  const Quaternion<double> phase = first > 0 ? x[0] / first : Quaternion<double>{1, 0, 0, 0};
  v[0] += phase * length;
  scale = length * (length + first);
  image = -phase * length;
}

CGP_INLINE void reflect_both_sides(Block<Quaternion<double>>& A, Eigen::Index k,
                                   const Quaternionic_reflection& H)
{
  const Eigen::Index n = A.rows() - k;
  Quaternion_vector<double> w = Quaternion_vector<double>::Constant(n, {});
  for (Eigen::Index j = 0; j < n; ++j)
    add_multiple(w, A.col(k + j).tail(n), Quaternion<double>(H.v[j] / H.scale));
  const double half = inner_product(H.v, w).w / (2 * H.scale);
  for (Eigen::Index j = 0; j < n; ++j) w[j] -= half * H.v[j];
  for (Eigen::Index j = 0; j < n; ++j) {
    add_multiple(A.col(k + j).tail(n), H.v, -conjugate(w[j]));
    add_multiple(A.col(k + j).tail(n), w, -conjugate(H.v[j]));
  }
}

CGP_INLINE void reflect_columns(Block<Quaternion<double>>& Q, Eigen::Index k,
                                const Quaternionic_reflection& H)
{
  Quaternion_vector<double> q = Quaternion_vector<double>::Constant(Q.rows(), {});
  for (Eigen::Index j = 0; j < H.v.size(); ++j) add_multiple(q, Q.col(k + j), H.v[j]);
  for (Eigen::Index j = 0; j < H.v.size(); ++j)
    add_multiple(Q.col(k + j), q, Quaternion<double>(-conjugate(H.v[j]) / H.scale));
}

}  // namespace internal

CGP_INLINE internal::Quaternionic_tridiagonalization tridiagonalized(Block<Quaternion<double>> A)
{
  const Eigen::Index d = A.rows();
  internal::Quaternionic_tridiagonalization T{Block<Quaternion<double>>::Constant(d, d, {}),
                                              Vector<double>(d), Vector<double>(d > 0 ? d - 1 : 0)};
  for (Eigen::Index i = 0; i < d; ++i) T.Q(i, i).w = 1;
  Quaternion<double> phase{1, 0, 0, 0};  // of column k of Q
  for (Eigen::Index k = 0; k + 1 < d; ++k) {
    T.diagonal[k] = A(k, k).w;
    const internal::Quaternionic_reflection H(A.col(k).tail(d - k - 1));
    if (H.scale > 0) {
      internal::reflect_both_sides(A, k + 1, H);
      internal::reflect_columns(T.Q, k + 1, H);
    }
    const Quaternion<double> below = H.image * phase;
    T.subdiagonal[k] = norm(below);
    phase = T.subdiagonal[k] > 0 ? below / T.subdiagonal[k] : Quaternion<double>{1, 0, 0, 0};
    // Later reflections do not change this column.
    for (Eigen::Index i = 0; i < d; ++i) T.Q(i, k + 1) = T.Q(i, k + 1) * phase;
  }
  if (d > 0) T.diagonal[d - 1] = A(d - 1, d - 1).w;
  return T;
}

CGP_INLINE internal::Hermitian_eigen_decomposition<Quaternion<double>> quaternionic_householder(
    Block<Quaternion<double>> A)
{
  const Eigen::Index d = A.rows();
  const internal::Quaternionic_tridiagonalization T = tridiagonalized(std::move(A));
  // Eigen compares the square of a subdiagonal entry with the diagonal, which has another unit.
  const double largest = (std::max)(T.diagonal.lpNorm<Eigen::Infinity>(),
                                    T.subdiagonal.lpNorm<Eigen::Infinity>()),
               unit = largest > 0 ? largest : 1;
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  if (!T.diagonal.allFinite() || !T.subdiagonal.allFinite() ||
      solver.computeFromTridiagonal(T.diagonal / unit, T.subdiagonal / unit).info() !=
          Eigen::Success)
    throw Solver_error("quaternionic_householder", "no convergence");
  internal::Hermitian_eigen_decomposition<Quaternion<double>> result{
      unit * solver.eigenvalues(), Block<Quaternion<double>>(d, d)};
  const auto numbers = [d](auto* data) { return Eigen::Map<Eigen::MatrixXd>(data, 4 * d, d); };
  numbers(&result.vectors.data()->w).noalias() =
      Eigen::Map<const Eigen::MatrixXd>(&T.Q.data()->w, 4 * d, d) * solver.eigenvectors();
  return result;
}

}  // namespace Conformal_geometry_processing

#endif
