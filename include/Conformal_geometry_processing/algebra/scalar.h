// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion.h>

#include <complex>
#include <type_traits>

namespace Conformal_geometry_processing {

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

/// \ingroup PkgAlgebra
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

/// \ingroup PkgAlgebra
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
