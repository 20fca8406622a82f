// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief An orientation-preserving Moebius transformation of R^3: f -> (a f + b) (c f + d)^-1 with
/// quaternions a, b, c, d and points f as imaginary quaternions [CGP 4.5.3].
///
/// All orientation-preserving conformal maps of R^3 with infinity are of this form. Images of
/// imaginary f are imaginary if and only if M = (a b; c d) satisfies
/// M^H (0 1; 1 0) M = s (0 1; 1 0) with a real number s, which is positive if orientation is
/// preserved; here s = 1. Then the map is the spin transformation with lambda = (c f + d)^-1,
/// df~ = conjugate(lambda) df lambda, and even
/// f~_j - f~_i = conjugate(lambda_i) (f_j - f_i) lambda_j for any two points at any distance.
///
/// Compositions that move points far away and back lose digits, like all matrix products; in this
/// case, transform the points step by step.
class Moebius_map {
 public:
  using Quaternion = Conformal_geometry_processing::Quaternion<double>;

  /// The identity
  Moebius_map() = default;

  /// \brief Constructs a map from its matrix, up to a positive factor
  /// \throw Precondition_error if the matrix does not map R^3 to itself and preserve orientation
  Moebius_map(const Quaternion& a, const Quaternion& b, const Quaternion& c, const Quaternion& d);

  /// f -> f + t
  static Moebius_map translation(const Eigen::Vector3d& t);

  /// f -> conjugate(q) f q: rotates as `spin()` does, and scales by |q|^2
  /// \pre q is not zero
  static Moebius_map rotation(const Quaternion& q);

  /// f -> factor f
  /// \pre factor > 0
  static Moebius_map scaling(double factor) { return rotation({std::sqrt(factor), 0, 0, 0}); }

  /// f -> f^-1 = -f / |f|^2: the inversion in the unit sphere composed with the reflection in the
  /// origin, which makes it orientation-preserving. Exchanges inside and outside of the unit
  /// sphere.
  static Moebius_map inversion() { return {{}, one, one, {}, Unchecked()}; }

  /// \brief f -> (f^-1 - c)^-1, which fixes the origin and maps c^-1 = -c / |c|^2 to infinity, with
  /// lambda = (1 - c f)^-1 [CGP 4.5.3]. Close to the identity for small c: f + f c f + ...
  static Moebius_map sphere_inversion(const Eigen::Vector3d& c);

  /// The composition A * B applies B first
  friend Moebius_map operator*(const Moebius_map& A, const Moebius_map& B)
  {
    return {A.m_a * B.m_a + A.m_b * B.m_c, A.m_a * B.m_b + A.m_b * B.m_d,
            A.m_c * B.m_a + A.m_d * B.m_c, A.m_c * B.m_b + A.m_d * B.m_d, Unchecked()};
  }

  Moebius_map inverse() const;

  /// Returns the image of a point
  /// \throw Precondition_error if it is infinite, or the point is not finite
  Eigen::Vector3d operator()(const Eigen::Vector3d& point) const;

  /// Returns lambda at a point
  /// \throw Precondition_error if the point is mapped to infinity or is not finite
  Quaternion spin(const Eigen::Vector3d& point) const;

  /// \brief Returns the images of several points, 3 x n
  /// \param function named in the exception
  /// \throw Precondition_error if an image is infinite, up to rounding, or a point is not finite;
  /// the message names the first one
  Eigen::Matrix3Xd transform(Eigen::Matrix3Xd points,
                             const std::string& function = "Moebius_map::transform") const;

  /// \brief Returns lambda at several points, n quaternions
  /// \throw Precondition_error as `transform()`
  Quaternion_vector<double> spins(const Eigen::Matrix3Xd& points,
                                  const std::string& function = "Moebius_map::spins") const;

 private:
  struct Unchecked {};
  static constexpr Quaternion one = {1, 0, 0, 0};

  Moebius_map(const Quaternion& a, const Quaternion& b, const Quaternion& c, const Quaternion& d,
              Unchecked);
  Eigen::Vector3d image(const Eigen::Vector3d& point, const Quaternion& lambda) const;
  bool is_zero(const Quaternion& q, const Eigen::Vector3d& point) const;

  Quaternion m_a = one, m_b, m_c, m_d = one;
};

}  // namespace Conformal_geometry_processing
