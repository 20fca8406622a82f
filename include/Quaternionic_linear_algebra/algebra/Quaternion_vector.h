// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <type_traits>

/// Allows quaternions in Eigen's matrices, and their multiplication by real numbers.
namespace Eigen {

template <class FT>
struct NumTraits<Conformal_geometry_processing::Quaternion<FT>>
    : GenericNumTraits<Conformal_geometry_processing::Quaternion<FT>> {
  using Real = FT;
  using NonInteger = Conformal_geometry_processing::Quaternion<FT>;
  using Nested = Conformal_geometry_processing::Quaternion<FT>;
  // IsComplex is 0, because Eigen assumes that complex numbers commute.
  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1 };
  enum { ReadCost = 4, AddCost = 4, MulCost = 28 };
};

template <class FT, class BinaryOp>
struct ScalarBinaryOpTraits<Conformal_geometry_processing::Quaternion<FT>, FT, BinaryOp> {
  using ReturnType = Conformal_geometry_processing::Quaternion<FT>;
};
template <class FT, class BinaryOp>
struct ScalarBinaryOpTraits<FT, Conformal_geometry_processing::Quaternion<FT>, BinaryOp> {
  using ReturnType = Conformal_geometry_processing::Quaternion<FT>;
};

}  // namespace Eigen

namespace Conformal_geometry_processing {

/// A column vector of scalars: numbers, complex numbers or quaternions
template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// Several columns of scalars
template <class Scalar>
using Block = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// One quaternion per vertex, or per face; zero-initialized
template <class FT>
using Quaternion_vector = Vector<Quaternion<FT>>;

/// \ingroup PkgAlgebra
/// The components of quaternions as a real 4 x n matrix in the same memory: column i is (w,x,y,z)
template <class FT>
Eigen::Map<const Eigen::Matrix<FT, 4, Eigen::Dynamic>> components(const Quaternion_vector<FT>& v)
{
  return {reinterpret_cast<const FT*>(v.data()), 4, v.size()};
}

/// \ingroup PkgAlgebra
/// Likewise, writable
template <class FT>
Eigen::Map<Eigen::Matrix<FT, 4, Eigen::Dynamic>> components(Quaternion_vector<FT>& v)
{
  return {reinterpret_cast<FT*>(v.data()), 4, v.size()};
}

namespace internal {

/// sum_i conjugate(a_i) b_i, term by term
template <class Scalar>
class Inner_product {
 public:
  void add(const Scalar& a, const Scalar& b) { m_sum += conjugate(a) * b; }

  /// Adds a b
  void add_product(const Scalar& a, const Scalar& b) { m_sum += a * b; }

  Inner_product& operator+=(const Inner_product& other)
  {
    m_sum += other.m_sum;
    return *this;
  }

  Scalar sum() const { return m_sum; }

 private:
  Scalar m_sum{};
};

// From the sum of the 4 x 4 matrices a_i b_i^T, whose rows fit the vector registers; a sum of
// products would permute components.
template <class FT>
class Inner_product<Quaternion<FT>> {
 public:
  void add(const Quaternion<FT>& a, const Quaternion<FT>& b)
  {
    const Four c = Eigen::Map<const Four>(&b.w);
    m_w += a.w * c;
    m_x += a.x * c;
    m_y += a.y * c;
    m_z += a.z * c;
  }

  void add_product(const Quaternion<FT>& a, const Quaternion<FT>& b)
  {
    const Four c = Eigen::Map<const Four>(&b.w);
    m_w += a.w * c;
    m_x -= a.x * c;
    m_y -= a.y * c;
    m_z -= a.z * c;
  }

  Inner_product& operator+=(const Inner_product& other)
  {
    m_w += other.m_w;
    m_x += other.m_x;
    m_y += other.m_y;
    m_z += other.m_z;
    return *this;
  }

  Quaternion<FT> sum() const
  {
    return {m_w[0] + m_x[1] + m_y[2] + m_z[3], m_w[1] - m_x[0] - m_y[3] + m_z[2],
            m_w[2] + m_x[3] - m_y[0] - m_z[1], m_w[3] - m_x[2] + m_y[1] - m_z[0]};
  }

 private:
  using Four = Eigen::Array<FT, 4, 1>;
  Four m_w = Four::Zero(), m_x = Four::Zero(), m_y = Four::Zero(), m_z = Four::Zero();
};

/// the sum of what `add(i, sum)` adds for 0 <= i < count, on several threads
template <class Scalar, class Add>
Scalar inner_product_of(Eigen::Index count, const Add& add)
{
  const std::ptrdiff_t at_once = 1024, least = 8;
  using Sum = Inner_product<Scalar>;
  const auto add_range = [&](std::ptrdiff_t first, std::ptrdiff_t last, Sum& sum) {
    for (std::ptrdiff_t i = first; i < last; ++i) add(i, sum);
  };
  return sum_of_ranges(count, at_once, Sum(), add_range, least).sum();
}

}  // namespace internal

/// \ingroup PkgAlgebra
/// Returns sum_i m_i conjugate(a_i) b_i, the quaternionic inner product with the masses m.
///
/// Right-linear in b: <a, b q> = <a, b> q, and <b, a> = conjugate(<a, b>).
template <class A, class B, class FT>
Quaternion<FT> inner_product(const Eigen::MatrixBase<A>& a, const Vector<FT>& m,
                             const Eigen::MatrixBase<B>& b)
{
  using Scalar = Quaternion<FT>;
  return internal::inner_product_of<Scalar>(
      a.size(), [&](Eigen::Index i, auto& sum) { sum.add(m[i] * a[i], b[i]); });
}

/// \ingroup PkgAlgebra
/// Returns sum_i conjugate(a_i) b_i, for numbers, complex numbers or quaternions
template <class A, class B>
typename A::Scalar inner_product(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b)
{
  using Scalar = typename A::Scalar;
  using FT = typename Eigen::NumTraits<Scalar>::Real;
  if constexpr (std::is_same_v<Scalar, Quaternion<FT>>) {
    return internal::inner_product_of<Scalar>(
        a.size(), [&](Eigen::Index i, auto& sum) { sum.add(a[i], b[i]); });
  } else {
    return a.dot(b);
  }
}

/// \ingroup PkgAlgebra
/// \brief Left multiplication by q as a real 4 x 4 matrix on (w, x, y, z) [CGP 5.1].
///
/// Its transpose is the block of conjugate(q); products of blocks are blocks of products.
template <class FT>
Eigen::Matrix<FT, 4, 4> real_block(const Quaternion<FT>& q)
{
  Eigen::Matrix<FT, 4, 4> m;
  m << q.w, -q.x, -q.y, -q.z,  //
      q.x, q.w, -q.z, q.y,     //
      q.y, q.z, q.w, -q.x,     //
      q.z, -q.y, q.x, q.w;
  return m;
}

/// \ingroup PkgAlgebra
/// \brief The two complex coordinates (w + x i, y - z i) of a quaternion.
///
/// q = alpha + j beta with alpha = w + x i, beta = y - z i: complex numbers act from the right, so
/// that left multiplication by a quaternion is complex-linear.
template <class FT>
Eigen::Matrix<std::complex<FT>, 2, 1> complex_coordinates(const Quaternion<FT>& q)
{
  const std::complex<FT> alpha(q.w, q.x), beta(q.y, -q.z);
  return {alpha, beta};
}

/// \ingroup PkgAlgebra
/// The quaternion with two complex coordinates; inverse of `complex_coordinates()`
template <class FT>
Quaternion<FT> quaternion(const std::complex<FT>& alpha, const std::complex<FT>& beta)
{
  return {alpha.real(), alpha.imag(), beta.real(), -beta.imag()};
}

/// \ingroup PkgAlgebra
/// \brief Left multiplication by q as a complex 2 x 2 matrix on `complex_coordinates()`.
///
/// Its conjugate transpose is the block of conjugate(q), hence a Hermitian quaternionic matrix of
/// size n corresponds to a Hermitian complex matrix of size 2n, which has each eigenvalue twice.
template <class FT>
Eigen::Matrix<std::complex<FT>, 2, 2> complex_block(const Quaternion<FT>& q)
{
  const std::complex<FT> alpha(q.w, q.x), beta(q.y, -q.z);
  Eigen::Matrix<std::complex<FT>, 2, 2> m;
  m << alpha, -std::conj(beta), beta, std::conj(alpha);
  return m;
}

/// \ingroup PkgAlgebra
/// \brief Random quaternions, whose components are independent and uniform in [-1/2, 1/2); the same
/// on every platform for the same seed.
///
/// A random vector has a component along every eigenvector, symmetric or not.
Block<Quaternion<double>> random_quaternions(Eigen::Index rows, Eigen::Index columns,
                                             unsigned seed);

}  // namespace Conformal_geometry_processing
