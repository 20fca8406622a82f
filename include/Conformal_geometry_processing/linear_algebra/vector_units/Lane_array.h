// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/vector_units/compiler_hints.h>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief A register type for compilers without vector types: an array, whose loops the compiler
/// may vectorize.
///
/// \tparam Unit makes the names of instances for different units distinct
template <class Unit, class Real, int size>
struct Lane_array {
  Real lanes[size];

  CGP_ALWAYS_INLINE Real& operator[](int lane) { return lanes[lane]; }
  CGP_ALWAYS_INLINE const Real& operator[](int lane) const { return lanes[lane]; }

  CGP_ALWAYS_INLINE Lane_array& operator+=(const Lane_array& b)
  {
    for (int l = 0; l < size; ++l) lanes[l] += b.lanes[l];
    return *this;
  }
  CGP_ALWAYS_INLINE Lane_array& operator-=(const Lane_array& b)
  {
    for (int l = 0; l < size; ++l) lanes[l] -= b.lanes[l];
    return *this;
  }
  CGP_ALWAYS_INLINE Lane_array& operator*=(const Lane_array& b)
  {
    for (int l = 0; l < size; ++l) lanes[l] *= b.lanes[l];
    return *this;
  }
  CGP_ALWAYS_INLINE Lane_array& operator*=(Real b)
  {
    for (int l = 0; l < size; ++l) lanes[l] *= b;
    return *this;
  }
  CGP_ALWAYS_INLINE Lane_array& operator/=(Real b)
  {
    for (int l = 0; l < size; ++l) lanes[l] /= b;
    return *this;
  }

  friend CGP_ALWAYS_INLINE Lane_array operator+(Lane_array a, const Lane_array& b)
  {
    return a += b;
  }
  friend CGP_ALWAYS_INLINE Lane_array operator-(Lane_array a, const Lane_array& b)
  {
    return a -= b;
  }
  friend CGP_ALWAYS_INLINE Lane_array operator*(Lane_array a, const Lane_array& b)
  {
    return a *= b;
  }
  friend CGP_ALWAYS_INLINE Lane_array operator*(Lane_array a, Real b) { return a *= b; }
  friend CGP_ALWAYS_INLINE Lane_array operator*(Real a, Lane_array b) { return b *= a; }
};

}  // namespace Conformal_geometry_processing::internal
