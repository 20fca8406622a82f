// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief Returns a unit quaternion q with conjugate(q) U q = V, which rotates U to V by the
/// smaller angle.
///
/// q = (1 - UV) / |1 - UV| = (1 + <U,V>, -U x V) / |...|, without angles [CGP 5.7]. For V = -U any
/// unit vector orthogonal to U is a solution (theta = pi), unlike in the text of [CGP 5.7], which
/// sets theta = 0; the returned one depends on U only.
///
/// \pre U and V are unit vectors
template <class FT>
Quaternion<FT> rotor(const Eigen::Matrix<FT, 3, 1>& U, const Eigen::Matrix<FT, 3, 1>& V)
{
  const FT almost_antipodal = FT(1e-8);
  const Quaternion<FT> q = Quaternion<FT>{1, 0, 0, 0} - imaginary(U) * imaginary(V);
  const FT length = norm(q);
  if (length < almost_antipodal) return imaginary(U.unitOrthogonal());
  return q / length;
}

/// \ingroup PkgAlgebra
/// \brief Returns the quaternion q with conjugate(q) v q = scale R v, |q|^2 = scale, for a rotation
/// R. Its sign makes the real part positive, unless that is small.
/// \pre R is a rotation, scale is positive
template <class FT>
Quaternion<FT> spin_of(const Eigen::Matrix<FT, 3, 3>& R, FT scale)
{
  using std::sqrt;
  // Eigen uses the convention q v conjugate(q).
  const Eigen::Quaternion<FT> r(R);
  return Quaternion<FT>{r.w(), -r.x(), -r.y(), -r.z()} * sqrt(scale);
}

}  // namespace Conformal_geometry_processing
