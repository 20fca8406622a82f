// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Eigenvalues>

#include <complex>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// The reflection 1 - v v^H / scale that maps x to a multiple of the first unit vector.
struct Quaternionic_reflection {
  Quaternion_vector<double> v;
  double scale = 0;                      // |v|^2 / 2; zero means the identity
  Quaternion<double> image{0, 0, 0, 0};  // the first entry of the reflected x

  explicit Quaternionic_reflection(const Quaternion_vector<double>& x) : v(x), image(x[0])
  {
    const double length = std::sqrt(inner_product(x, x).w), first = norm(x[0]);
    if (!(length > first)) return;
    const Quaternion<double> phase = first > 0 ? x[0] / first : Quaternion<double>{1, 0, 0, 0};
    v[0] += phase * length;
    scale = length * (length + first);
    image = -phase * length;
  }
};

inline void reflect_both_sides(Block<Quaternion<double>>& A, Eigen::Index k,
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

inline void reflect_columns(Block<Quaternion<double>>& Q, Eigen::Index k,
                            const Quaternionic_reflection& H)
{
  Quaternion_vector<double> q = Quaternion_vector<double>::Constant(Q.rows(), {});
  for (Eigen::Index j = 0; j < H.v.size(); ++j) add_multiple(q, Q.col(k + j), H.v[j]);
  for (Eigen::Index j = 0; j < H.v.size(); ++j)
    add_multiple(Q.col(k + j), q, Quaternion<double>(-conjugate(H.v[j]) / H.scale));
}

inline Quaternionic_tridiagonalization tridiagonalized(Block<Quaternion<double>> A)
{
  const Eigen::Index d = A.rows();
  Quaternionic_tridiagonalization T{Block<Quaternion<double>>::Constant(d, d, {}),
                                    Vector<double>(d), Vector<double>(d > 0 ? d - 1 : 0)};
  for (Eigen::Index i = 0; i < d; ++i) T.Q(i, i).w = 1;
  Quaternion<double> phase{1, 0, 0, 0};  // of column k of Q
  for (Eigen::Index k = 0; k + 1 < d; ++k) {
    T.diagonal[k] = A(k, k).w;
    const Quaternionic_reflection H(A.col(k).tail(d - k - 1));
    if (H.scale > 0) {
      reflect_both_sides(A, k + 1, H);
      reflect_columns(T.Q, k + 1, H);
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

inline Hermitian_eigen_decomposition<Quaternion<double>> decomposition_of(
    Block<Quaternion<double>> A)
{
  const Eigen::Index d = A.rows();
  const Quaternionic_tridiagonalization T = tridiagonalized(std::move(A));
  const Hermitian_eigen_decomposition<double> real = found_by_eigen<double>(
      [&T](auto& solver) { solver.computeFromTridiagonal(T.diagonal, T.subdiagonal); });
  Hermitian_eigen_decomposition<Quaternion<double>> result{real.values,
                                                           Block<Quaternion<double>>(d, d)};
  Eigen::Map<Block<double>>(&result.vectors.data()->w, 4 * d, d).noalias() =
      Eigen::Map<const Block<double>>(&T.Q.data()->w, 4 * d, d) * real.vectors;
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

template internal::Hermitian_eigen_decomposition<double> hermitian_eigen_decomposition(
    Block<double>);
template internal::Hermitian_eigen_decomposition<std::complex<double>>
    hermitian_eigen_decomposition(Block<std::complex<double>>);
template internal::Hermitian_eigen_decomposition<Quaternion<double>> hermitian_eigen_decomposition(
    Block<Quaternion<double>>);

}  // namespace Conformal_geometry_processing
