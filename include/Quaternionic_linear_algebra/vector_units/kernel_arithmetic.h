// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#ifndef __GNUC__
#include <math.h>
#endif

// Compiler-specific hints for the dense kernels. This file, and all that a kernel includes, must
// not define functions that could be called from a file compiled for another vector unit: the
// linker keeps an arbitrary one of several functions with the same name.

#if defined(__GNUC__) && !defined(CONFORMAL_GEOMETRY_PROCESSING_NO_VECTOR_EXTENSIONS)
#define CGP_HAS_VECTOR_EXTENSIONS  // vector types
#endif

#define CGP_PRAGMA(text) _Pragma(#text)

#if defined(__clang__)
#define CGP_ALWAYS_INLINE inline __attribute__((always_inline))
#define CGP_UNROLL(count) CGP_PRAGMA(unroll)
#define CGP_PREFETCH(address) __builtin_prefetch(address)
#elif defined(__GNUC__)
#define CGP_ALWAYS_INLINE inline __attribute__((always_inline))
#define CGP_UNROLL(count) CGP_PRAGMA(GCC unroll count)
#define CGP_PREFETCH(address) __builtin_prefetch(address)
#else
#ifdef _MSC_VER
#define CGP_ALWAYS_INLINE __forceinline
#else
#define CGP_ALWAYS_INLINE inline
#endif
#define CGP_UNROLL(count)
#define CGP_PREFETCH(address) static_cast<void>(address)
#endif

// Replacements for functions of <algorithm> and <cmath>, which are not always inlined.

namespace Conformal_geometry_processing::internal {

template <class T>
CGP_ALWAYS_INLINE constexpr T least(T a, T b)
{
  return b < a ? b : a;
}

template <class T>
CGP_ALWAYS_INLINE constexpr T greatest(T a, T b)
{
  return a < b ? b : a;
}

/// whether x is positive and neither x nor 1/x overflows
template <class Real>
CGP_ALWAYS_INLINE bool is_good_pivot(Real x)
{
  const Real reciprocal = 1 / x;
  return x > 0 && x - x == 0 && reciprocal - reciprocal == 0;  // infinity - infinity is not 0
}

#ifdef __GNUC__
CGP_ALWAYS_INLINE double square_root(double x)
{
  return __builtin_sqrt(x);
}
CGP_ALWAYS_INLINE float square_root(float x)
{
  return __builtin_sqrtf(x);
}
#else
CGP_ALWAYS_INLINE double square_root(double x)
{
  return ::sqrt(x);
}
CGP_ALWAYS_INLINE float square_root(float x)
{
  return ::sqrtf(x);
}
#endif

template <class Real>
CGP_ALWAYS_INLINE void set_zero(Real* to, long long count)
{
  for (long long i = 0; i < count; ++i) to[i] = Real(0);
}

/// \brief Products of scalars that are arrays of their real components: 1 of a real number, 2 of a
/// complex one, 4 of a quaternion. The same dense kernels are used for all three.
///
/// In all products `a` and `c` may be vectors of several scalars (one register per component) and b
/// one scalar, or vice versa.
template <int planes>
struct Plane_products;

template <>
struct Plane_products<1> {
  /// c -= a conjugate(b)
  template <class C, class A, class B>
  static CGP_ALWAYS_INLINE void subtract_conjugated(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0];
  }
  /// c -= a b
  template <class C, class A, class B>
  static CGP_ALWAYS_INLINE void subtract(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0];
  }
  /// c += conjugate(a) b
  template <class C, class A, class B>
  static CGP_ALWAYS_INLINE void add_conjugate(C* c, const A* a, const B* b)
  {
    c[0] += a[0] * b[0];
  }
};

template <>
struct Plane_products<2> {
  template <class C, class A, class B>
  static CGP_ALWAYS_INLINE void subtract_conjugated(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0], c[1] -= a[1] * b[0];
    c[0] -= a[1] * b[1], c[1] += a[0] * b[1];
  }
  template <class C, class A, class B>
  static CGP_ALWAYS_INLINE void subtract(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0], c[1] -= a[1] * b[0];
    c[0] += a[1] * b[1], c[1] -= a[0] * b[1];
  }
  template <class C, class A, class B>
  static CGP_ALWAYS_INLINE void add_conjugate(C* c, const A* a, const B* b)
  {
    c[0] += a[0] * b[0], c[1] += a[0] * b[1];
    c[0] += a[1] * b[1], c[1] -= a[1] * b[0];
  }
};

template <>
struct Plane_products<4> {
  template <class C, class A, class B>
  static CGP_ALWAYS_INLINE void subtract_conjugated(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0], c[1] += a[0] * b[1], c[2] += a[0] * b[2], c[3] += a[0] * b[3];
    c[0] -= a[1] * b[1], c[1] -= a[1] * b[0], c[2] -= a[1] * b[3], c[3] += a[1] * b[2];
    c[0] -= a[2] * b[2], c[1] += a[2] * b[3], c[2] -= a[2] * b[0], c[3] -= a[2] * b[1];
    c[0] -= a[3] * b[3], c[1] -= a[3] * b[2], c[2] += a[3] * b[1], c[3] -= a[3] * b[0];
  }
  template <class C, class A, class B>
  static CGP_ALWAYS_INLINE void subtract(C* c, const A* a, const B* b)
  {
    c[0] -= a[0] * b[0], c[1] -= a[0] * b[1], c[2] -= a[0] * b[2], c[3] -= a[0] * b[3];
    c[0] += a[1] * b[1], c[1] -= a[1] * b[0], c[2] += a[1] * b[3], c[3] -= a[1] * b[2];
    c[0] += a[2] * b[2], c[1] -= a[2] * b[3], c[2] -= a[2] * b[0], c[3] += a[2] * b[1];
    c[0] += a[3] * b[3], c[1] += a[3] * b[2], c[2] -= a[3] * b[1], c[3] -= a[3] * b[0];
  }
  template <class C, class A, class B>
  static CGP_ALWAYS_INLINE void add_conjugate(C* c, const A* a, const B* b)
  {
    c[0] += a[0] * b[0], c[1] += a[0] * b[1], c[2] += a[0] * b[2], c[3] += a[0] * b[3];
    c[0] += a[1] * b[1], c[1] -= a[1] * b[0], c[2] += a[1] * b[3], c[3] -= a[1] * b[2];
    c[0] += a[2] * b[2], c[1] -= a[2] * b[3], c[2] -= a[2] * b[0], c[3] += a[2] * b[1];
    c[0] += a[3] * b[3], c[1] += a[3] * b[2], c[2] -= a[3] * b[1], c[3] -= a[3] * b[0];
  }
};

}  // namespace Conformal_geometry_processing::internal
