// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_PLAIN_FUNCTIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_PLAIN_FUNCTIONS_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/compiler_hints.h>

#ifndef __GNUC__
#include <math.h>
#endif

// Replacements for functions of <algorithm> and <cmath>, which are not always inlined.

namespace Conformal_geometry_processing {
namespace internal {

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

template <class Real>
CGP_ALWAYS_INLINE bool is_positive_and_finite(Real x)
{
  return x > 0 && x - x == 0;  // the difference of infinities is not a number
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

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
