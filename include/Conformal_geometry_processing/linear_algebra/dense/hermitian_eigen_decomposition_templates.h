// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_HERMITIAN_EIGEN_DECOMPOSITION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_HERMITIAN_EIGEN_DECOMPOSITION_TEMPLATES_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <complex>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief A = Q T Q^H with Q^H Q = 1 and a *real* symmetric tridiagonal T, for a quaternionic
/// Hermitian matrix A.
template <class FT>
struct Quaternionic_tridiagonalization {
  Block<Quaternion<FT>> Q;
  Vector<FT> diagonal;
  Vector<FT> subdiagonal;  ///< not negative; has one entry less
};

/// The reflection 1 - v v^H / scale that maps x to a multiple of the first unit vector.
template <class FT>
struct Quaternionic_reflection {
  Quaternion_vector<FT> v;
  FT scale = 0;                      // |v|^2 / 2; zero means the identity
  Quaternion<FT> image{0, 0, 0, 0};  // the first entry of the reflected x

  explicit Quaternionic_reflection(const Quaternion_vector<FT>& x) : v(x), image(x[0])
  {
    const FT length = std::sqrt(inner_product(x, x).w), first = norm(x[0]);
    if (!(length > first)) return;
    const Quaternion<FT> phase = first > 0 ? x[0] / first : Quaternion<FT>{1, 0, 0, 0};
    v[0] += phase * length;
    scale = length * (length + first);
    image = -phase * length;
  }
};

template <class FT>
void reflect_both_sides(Block<Quaternion<FT>>& A, Eigen::Index k,
                        const Quaternionic_reflection<FT>& H)
{
  const Eigen::Index n = A.rows() - k;
  Quaternion_vector<FT> w = Quaternion_vector<FT>::Constant(n, {});
  for (Eigen::Index j = 0; j < n; ++j)
    add_multiple(w, A.col(k + j).tail(n), Quaternion<FT>(H.v[j] / H.scale));
  const FT half = inner_product(H.v, w).w / (2 * H.scale);
  for (Eigen::Index j = 0; j < n; ++j) w[j] -= half * H.v[j];
  for (Eigen::Index j = 0; j < n; ++j) {
    add_multiple(A.col(k + j).tail(n), H.v, -conjugate(w[j]));
    add_multiple(A.col(k + j).tail(n), w, -conjugate(H.v[j]));
  }
}

template <class FT>
void reflect_columns(Block<Quaternion<FT>>& Q, Eigen::Index k, const Quaternionic_reflection<FT>& H)
{
  Quaternion_vector<FT> q = Quaternion_vector<FT>::Constant(Q.rows(), {});
  for (Eigen::Index j = 0; j < H.v.size(); ++j) add_multiple(q, Q.col(k + j), H.v[j]);
  for (Eigen::Index j = 0; j < H.v.size(); ++j)
    add_multiple(Q.col(k + j), q, Quaternion<FT>(-conjugate(H.v[j]) / H.scale));
}

/// \brief by reflections, each of which annihilates a column below the subdiagonal, and by phases
/// that make the subdiagonal real. About 7/3 d^3 quaternionic products.
/// \pre A is Hermitian
template <class FT>
Quaternionic_tridiagonalization<FT> tridiagonalized(Block<Quaternion<FT>> A)
{
  const Eigen::Index d = A.rows();
  Quaternionic_tridiagonalization<FT> T{Block<Quaternion<FT>>::Constant(d, d, {}), Vector<FT>(d),
                                        Vector<FT>(d > 0 ? d - 1 : 0)};
  for (Eigen::Index i = 0; i < d; ++i) T.Q(i, i).w = 1;
  Quaternion<FT> phase{1, 0, 0, 0};  // of column k of Q
  for (Eigen::Index k = 0; k + 1 < d; ++k) {
    T.diagonal[k] = A(k, k).w;
    const Quaternionic_reflection<FT> H(A.col(k).tail(d - k - 1));
    if (H.scale > 0) {
      reflect_both_sides(A, k + 1, H);
      reflect_columns(T.Q, k + 1, H);
    }
    const Quaternion<FT> below = H.image * phase;
    T.subdiagonal[k] = norm(below);
    phase = T.subdiagonal[k] > 0 ? below / T.subdiagonal[k] : Quaternion<FT>{1, 0, 0, 0};
    // Later reflections do not change this column.
    for (Eigen::Index i = 0; i < d; ++i) T.Q(i, k + 1) = T.Q(i, k + 1) * phase;
  }
  if (d > 0) T.diagonal[d - 1] = A(d - 1, d - 1).w;
  return T;
}

/// what Eigen finds where `compute` makes the solver compute
template <class Scalar, class Compute>
Hermitian_eigen_decomposition<Scalar> found_by_eigen(const Compute& compute)
{
  Eigen::SelfAdjointEigenSolver<Block<Scalar>> solver;
  compute(solver);
  if (solver.info() != Eigen::Success)
    throw Solver_error("hermitian_eigen_decomposition", "no convergence");
  return {solver.eigenvalues(), solver.eigenvectors()};
}

template <class Scalar>
Hermitian_eigen_decomposition<Scalar> decomposition_of(const Block<Scalar>& A)
{
  return found_by_eigen<Scalar>([&A](auto& solver) { solver.compute(A); });
}

template <class FT>
Hermitian_eigen_decomposition<Quaternion<FT>> decomposition_of(Block<Quaternion<FT>> A)
{
  const Eigen::Index d = A.rows();
  const Quaternionic_tridiagonalization<FT> T = tridiagonalized(std::move(A));
  const Hermitian_eigen_decomposition<FT> real = found_by_eigen<FT>(
      [&T](auto& solver) { solver.computeFromTridiagonal(T.diagonal, T.subdiagonal); });
  Hermitian_eigen_decomposition<Quaternion<FT>> result{real.values, Block<Quaternion<FT>>(d, d)};
  Eigen::Map<Block<FT>>(&result.vectors.data()->w, 4 * d, d).noalias() =
      Eigen::Map<const Block<FT>>(&T.Q.data()->w, 4 * d, d) * real.vectors;
  return result;
}

}  // namespace internal

template <class Scalar>
internal::Hermitian_eigen_decomposition<Scalar> hermitian_eigen_decomposition(Block<Scalar> A)
{
  using FT = typename internal::Scalar_traits<Scalar>::FT;
  if (A.size() == 0) return {Vector<FT>(0), std::move(A)};
  Eigen::Map<Vector<FT>> numbers(reinterpret_cast<FT*>(A.data()),
                                 A.size() * Eigen::Index(sizeof(Scalar) / sizeof(FT)));
  if (!numbers.allFinite())
    throw Solver_error("hermitian_eigen_decomposition", "a value of the matrix is not finite");
  // Dividing by a power of two is exact, and prevents overflow and underflow of squares.
  const FT largest = numbers.template lpNorm<Eigen::Infinity>(),
           unit = largest > 0 ? std::scalbn(FT(1), std::ilogb(largest)) : FT(1);
  numbers /= unit;
  internal::Hermitian_eigen_decomposition<Scalar> result = internal::decomposition_of(std::move(A));
  result.values *= unit;
  return result;
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template internal::Hermitian_eigen_decomposition<double> hermitian_eigen_decomposition(
    Block<double>);
extern template internal::Hermitian_eigen_decomposition<std::complex<double>>
    hermitian_eigen_decomposition(Block<std::complex<double>>);
extern template internal::Hermitian_eigen_decomposition<Quaternion<double>>
    hermitian_eigen_decomposition(Block<Quaternion<double>>);

}  // namespace Conformal_geometry_processing
#endif

#endif
