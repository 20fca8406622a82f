// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SCALAR_PLANES_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SCALAR_PLANES_H

#include <Conformal_geometry_processing/algebra/scalar.h>

#include <complex>

#define CONFORMAL_GEOMETRY_PROCESSING_INLINE inline __attribute__((always_inline))

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief scalars as arrays of their real components, so that one dense kernel serves real, complex
/// and quaternionic matrices.
///
/// In all products `a` and `c` may be vectors of several scalars (one register per component) and b
/// one scalar, or the other way round.
template <class Scalar>
struct Scalar_planes;

template <class Real>
struct Real_planes {
  static constexpr int size = 1;

  /// c -= a conjugate(b)
  template <class C, class A, class B>
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract_conjugated(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0];
  }
  /// c -= a b
  template <class C, class A, class B>
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0];
  }
  /// c += conjugate(a) b
  template <class C, class A, class B>
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void add_conjugate(C* c, const A* a, const B* b)
  {
    c[0] += a[0] * b[0];
  }
};

template <>
struct Scalar_planes<double> : Real_planes<double> {
  static void get(double s, double* c) { c[0] = s; }
  static double put(const double* c) { return c[0]; }
};
template <>
struct Scalar_planes<float> : Real_planes<float> {
  static void get(float s, float* c) { c[0] = s; }
  static float put(const float* c) { return c[0]; }
};

template <class FT>
struct Scalar_planes<std::complex<FT>> {
  static constexpr int size = 2;

  static void get(const std::complex<FT>& s, FT* c) { c[0] = s.real(), c[1] = s.imag(); }
  static std::complex<FT> put(const FT* c) { return {c[0], c[1]}; }

  template <class C, class A, class B>
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract_conjugated(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0], c[1] -= a[1] * b[0];
    c[0] -= a[1] * b[1], c[1] += a[0] * b[1];
  }
  template <class C, class A, class B>
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0], c[1] -= a[1] * b[0];
    c[0] += a[1] * b[1], c[1] -= a[0] * b[1];
  }
  template <class C, class A, class B>
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void add_conjugate(C* c, const A* a, const B* b)
  {
    c[0] += a[0] * b[0], c[1] += a[0] * b[1];
    c[0] += a[1] * b[1], c[1] -= a[1] * b[0];
  }
};

template <class FT>
struct Scalar_planes<Quaternion<FT>> {
  static constexpr int size = 4;

  static void get(const Quaternion<FT>& s, FT* c)
  {
    c[0] = s.w, c[1] = s.x, c[2] = s.y, c[3] = s.z;
  }
  static Quaternion<FT> put(const FT* c) { return {c[0], c[1], c[2], c[3]}; }

  template <class C, class A, class B>
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract_conjugated(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0], c[1] += a[0] * b[1], c[2] += a[0] * b[2], c[3] += a[0] * b[3];
    c[0] -= a[1] * b[1], c[1] -= a[1] * b[0], c[2] -= a[1] * b[3], c[3] += a[1] * b[2];
    c[0] -= a[2] * b[2], c[1] += a[2] * b[3], c[2] -= a[2] * b[0], c[3] -= a[2] * b[1];
    c[0] -= a[3] * b[3], c[1] -= a[3] * b[2], c[2] += a[3] * b[1], c[3] -= a[3] * b[0];
  }
  template <class C, class A, class B>
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0], c[1] -= a[0] * b[1], c[2] -= a[0] * b[2], c[3] -= a[0] * b[3];
    c[0] += a[1] * b[1], c[1] -= a[1] * b[0], c[2] += a[1] * b[3], c[3] -= a[1] * b[2];
    c[0] += a[2] * b[2], c[1] -= a[2] * b[3], c[2] -= a[2] * b[0], c[3] += a[2] * b[1];
    c[0] += a[3] * b[3], c[1] += a[3] * b[2], c[2] -= a[3] * b[1], c[3] -= a[3] * b[0];
  }
  template <class C, class A, class B>
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void add_conjugate(C* c, const A* a, const B* b)
  {
    c[0] += a[0] * b[0], c[1] += a[0] * b[1], c[2] += a[0] * b[2], c[3] += a[0] * b[3];
    c[0] += a[1] * b[1], c[1] -= a[1] * b[0], c[2] += a[1] * b[3], c[3] -= a[1] * b[2];
    c[0] += a[2] * b[2], c[1] -= a[2] * b[3], c[2] -= a[2] * b[0], c[3] += a[2] * b[1];
    c[0] += a[3] * b[3], c[1] += a[3] * b[2], c[2] -= a[3] * b[1], c[3] -= a[3] * b[0];
  }
};

}  // namespace Conformal_geometry_processing

#endif
