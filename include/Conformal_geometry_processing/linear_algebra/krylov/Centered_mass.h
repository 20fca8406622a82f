// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief The quadratic form D - D C C^H D, which ignores some directions of x: D >= 0 is diagonal,
/// and the columns of C are D-orthonormal.
///
/// If C contains the constants, the form measures the variance of x, independently of its mean.
/// Positive semidefinite. \tparam Scalar_ `double` or `std::complex<double>`
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

}  // namespace Conformal_geometry_processing::internal
