// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <type_traits>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// \brief The quaternion w + x i + y j + z k with ij = k, jk = i, ki = j [CGP 2.5].
///
/// Vectors of R^3 are identified with imaginary quaternions (w = 0), for which
/// pq = p x q - <p, q>. An aggregate of four numbers without padding, so that an array of
/// quaternions is also an array of numbers.
///
/// \tparam FT_ a floating-point type
template <class FT_>
struct Quaternion {
  using FT = FT_;
  FT w{}, x{}, y{}, z{};

  constexpr Quaternion& operator+=(const Quaternion& q)
  {
    w += q.w, x += q.x, y += q.y, z += q.z;
    return *this;
  }
  constexpr Quaternion& operator-=(const Quaternion& q)
  {
    w -= q.w, x -= q.x, y -= q.y, z -= q.z;
    return *this;
  }
  constexpr Quaternion& operator*=(FT s)
  {
    w *= s, x *= s, y *= s, z *= s;
    return *this;
  }

  friend constexpr Quaternion operator+(Quaternion p, const Quaternion& q) { return p += q; }
  friend constexpr Quaternion operator-(Quaternion p, const Quaternion& q) { return p -= q; }
  friend constexpr Quaternion operator-(const Quaternion& q) { return {-q.w, -q.x, -q.y, -q.z}; }
  friend constexpr Quaternion operator*(Quaternion q, FT s) { return q *= s; }
  friend constexpr Quaternion operator*(FT s, Quaternion q) { return q *= s; }
  friend constexpr Quaternion operator/(const Quaternion& q, FT s)
  {
    return {q.w / s, q.x / s, q.y / s, q.z / s};
  }

  /// The Hamilton product
  friend constexpr Quaternion operator*(const Quaternion& p, const Quaternion& q)
  {
    return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z,
            p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
            p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x,
            p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
  }

  friend constexpr bool operator==(const Quaternion& p, const Quaternion& q)
  {
    return p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z;
  }
  friend constexpr bool operator!=(const Quaternion& p, const Quaternion& q) { return !(p == q); }
};

/// \relates Quaternion
/// w - x i - y j - z k; conjugate(p q) = conjugate(q) conjugate(p)
template <class FT>
constexpr Quaternion<FT> conjugate(const Quaternion<FT>& q)
{
  return {q.w, -q.x, -q.y, -q.z};
}

/// \relates Quaternion
/// <p, q> = Re(conjugate(p) q), the scalar product of R^4
template <class FT>
constexpr FT dot(const Quaternion<FT>& p, const Quaternion<FT>& q)
{
  return p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z;
}

/// \relates Quaternion
/// |q|^2 = conjugate(q) q
template <class FT>
constexpr FT squared_norm(const Quaternion<FT>& q)
{
  return dot(q, q);
}

/// \relates Quaternion
/// |q|
template <class FT>
FT norm(const Quaternion<FT>& q)
{
  using std::sqrt;
  return sqrt(squared_norm(q));
}

/// \relates Quaternion
/// conjugate(q) / |q|^2
/// \pre q is not zero
template <class FT>
constexpr Quaternion<FT> inverse(const Quaternion<FT>& q)
{
  return conjugate(q) / squared_norm(q);
}

/// \relates Quaternion
/// The vector (x, y, z)
template <class FT>
Eigen::Matrix<FT, 3, 1> imaginary_part(const Quaternion<FT>& q)
{
  return {q.x, q.y, q.z};
}

/// \relates Quaternion
/// Converts a vector of R^3 to an imaginary quaternion
template <class Vector3>
Quaternion<typename Vector3::Scalar> imaginary(const Eigen::MatrixBase<Vector3>& v)
{
  return {0, v(0), v(1), v(2)};
}

/// \relates Quaternion
/// Returns conjugate(q) v q for a vector v: rotates by +theta about u (right-hand rule), where
/// q = |q| (cos(theta/2) - sin(theta/2) u), and scales by |q|^2 [CGP 2.5]
template <class FT, class Vector3>
Eigen::Matrix<FT, 3, 1> spin(const Quaternion<FT>& q, const Eigen::MatrixBase<Vector3>& v)
{
  return imaginary_part(conjugate(q) * imaginary(v) * q);
}

static_assert(std::is_aggregate_v<Quaternion<double>> &&
              std::is_trivially_copyable_v<Quaternion<double>> &&
              sizeof(Quaternion<double>) == 4 * sizeof(double));

/// The conjugate of a real number, for templates over scalars
template <class FT, class = std::enable_if_t<std::is_floating_point_v<FT>>>
constexpr FT conjugate(FT s)
{
  return s;
}

/// The complex conjugate
template <class FT>
std::complex<FT> conjugate(const std::complex<FT>& s)
{
  return std::conj(s);
}

namespace internal {

/// Properties of a scalar type: the type of its real components, and the real part
template <class Scalar>
struct Scalar_traits {
  using FT = Scalar;
  static constexpr FT real(const Scalar& s) { return s; }
  static constexpr Scalar from_real(FT s) { return s; }
};

template <class FT_>
struct Scalar_traits<std::complex<FT_>> {
  using FT = FT_;
  static constexpr FT real(const std::complex<FT>& s) { return s.real(); }
  static constexpr std::complex<FT> from_real(FT s) { return s; }
};

template <class FT_>
struct Scalar_traits<Quaternion<FT_>> {
  using FT = FT_;
  static constexpr FT real(const Quaternion<FT>& s) { return s.w; }
  static constexpr Quaternion<FT> from_real(FT s) { return {s, 0, 0, 0}; }
};

/// \brief Scalars as arrays of their real components, so that the same dense kernels work for real,
/// complex and quaternionic matrices (see `Plane_products`).
template <class Scalar>
struct Scalar_planes;

template <>
struct Scalar_planes<double> {
  static constexpr int size = 1;

  static void get(double s, double* c) { c[0] = s; }
  static double put(const double* c) { return c[0]; }
};

template <>
struct Scalar_planes<float> {
  static constexpr int size = 1;

  static void get(float s, float* c) { c[0] = s; }
  static float put(const float* c) { return c[0]; }
};

template <class FT>
struct Scalar_planes<std::complex<FT>> {
  static constexpr int size = 2;

  static void get(const std::complex<FT>& s, FT* c) { c[0] = s.real(), c[1] = s.imag(); }
  static std::complex<FT> put(const FT* c) { return {c[0], c[1]}; }
};

template <class FT>
struct Scalar_planes<Quaternion<FT>> {
  static constexpr int size = 4;

  static void get(const Quaternion<FT>& s, FT* c)
  {
    c[0] = s.w, c[1] = s.x, c[2] = s.y, c[3] = s.z;
  }
  static Quaternion<FT> put(const FT* c) { return {c[0], c[1], c[2], c[3]}; }
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
