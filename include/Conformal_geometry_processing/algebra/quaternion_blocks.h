// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <complex>

namespace Conformal_geometry_processing {

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
/// Converts a vector of n quaternions to 2n complex numbers
template <class FT>
Vector<std::complex<FT>> to_complex(const Quaternion_vector<FT>& v)
{
  Vector<std::complex<FT>> c(2 * v.size());
  for (Eigen::Index i = 0; i < v.size(); ++i)
    c.template segment<2>(2 * i) = complex_coordinates(v[i]);
  return c;
}

/// \ingroup PkgAlgebra
/// Converts 2n complex numbers to a vector of n quaternions
template <class FT>
Quaternion_vector<FT> from_complex(const Vector<std::complex<FT>>& c)
{
  Quaternion_vector<FT> v(c.size() / 2);
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = quaternion(c[2 * i], c[2 * i + 1]);
  return v;
}

}  // namespace Conformal_geometry_processing
