// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_QUATERNION_VECTOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_QUATERNION_VECTOR_H

#include <Conformal_geometry_processing/algebra/scalar.h>

#include <Eigen/Core>

/// Lets Eigen's containers hold quaternions, and multiply them by numbers of their field.
namespace Eigen {

template <class FT>
struct NumTraits<Conformal_geometry_processing::Quaternion<FT>>
    : GenericNumTraits<Conformal_geometry_processing::Quaternion<FT>> {
  using Real = FT;
  using NonInteger = Conformal_geometry_processing::Quaternion<FT>;
  using Nested = Conformal_geometry_processing::Quaternion<FT>;
  // IsComplex stays 0: Eigen's complex means commutative.
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

/// a column of scalars: numbers, complex numbers or quaternions
template <class Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// several columns of scalars, side by side
template <class Scalar>
using Block = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// one quaternion per vertex, or per face; all zero after construction
template <class FT>
using Quaternion_vector = Vector<Quaternion<FT>>;

/// \ingroup PkgAlgebra
/// the components of quaternions as a real 4 x n matrix over the same memory: column i is (w,x,y,z)
template <class FT>
Eigen::Map<const Eigen::Matrix<FT, 4, Eigen::Dynamic>> components(const Quaternion_vector<FT>& v)
{
  return {reinterpret_cast<const FT*>(v.data()), 4, v.size()};
}

/// \ingroup PkgAlgebra
/// the same, to be written to
template <class FT>
Eigen::Map<Eigen::Matrix<FT, 4, Eigen::Dynamic>> components(Quaternion_vector<FT>& v)
{
  return {reinterpret_cast<FT*>(v.data()), 4, v.size()};
}

/// \ingroup PkgAlgebra
/// sum_i m_i conjugate(a_i) b_i, the quaternionic inner product with the masses m.
///
/// Right-linear in b: <a, b q> = <a, b> q, and <b, a> = conjugate(<a, b>).
template <class A, class B, class FT>
Quaternion<FT> inner_product(const Eigen::MatrixBase<A>& a, const Vector<FT>& m,
                             const Eigen::MatrixBase<B>& b)
{
  Quaternion<FT> sum;
  for (Eigen::Index i = 0; i < a.size(); ++i) sum += m[i] * (conjugate(a[i]) * b[i]);
  return sum;
}

/// \ingroup PkgAlgebra
/// sum_i conjugate(a_i) b_i
template <class A, class B>
typename A::Scalar inner_product(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b)
{
  typename A::Scalar sum{};
  for (Eigen::Index i = 0; i < a.size(); ++i) sum += conjugate(a[i]) * b[i];
  return sum;
}

}  // namespace Conformal_geometry_processing

#endif
