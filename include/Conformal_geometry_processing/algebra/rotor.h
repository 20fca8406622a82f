// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_ROTOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_ROTOR_H

#include <Conformal_geometry_processing/algebra/Quaternion.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief a unit quaternion q with conjugate(q) U q = V: turns U into V by the smaller angle.
///
/// q = (1 - UV) / |1 - UV| = (1 + <U,V>, -U x V) / |...|, without angles [CGP 5.7]. Unlike the
/// text of [CGP 5.7], which sets theta = 0 there, for V = -U any unit vector orthogonal to U
/// serves (theta = pi); the one returned depends on U alone.
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
/// \brief the quaternion q with conjugate(q) v q = scale R v, |q|^2 = scale, for a rotation R; of
/// its two signs, one with a positive real part if that is not small. \pre R is a rotation, scale
/// is positive
template <class FT>
Quaternion<FT> spin_of(const Eigen::Matrix<FT, 3, 3>& R, FT scale)
{
  using std::sqrt;
  // Eigen has q v conjugate(q).
  const Eigen::Quaternion<FT> r(R);
  return Quaternion<FT>{r.w(), -r.x(), -r.y(), -r.z()} * sqrt(scale);
}

}  // namespace Conformal_geometry_processing

#endif
