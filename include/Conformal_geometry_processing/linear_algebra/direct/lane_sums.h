// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_LANE_SUMS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_LANE_SUMS_H

#include <Conformal_geometry_processing/linear_algebra/direct/Scalar_planes.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Simd_lanes.h>

#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

// The lanes first, first + 2, ... of a and then of b, by one instruction where compilers have it.
template <class Register, int first, int... lane>
CONFORMAL_GEOMETRY_PROCESSING_INLINE Register every_other(const Register& a, const Register& b,
                                                          std::integer_sequence<int, lane...>)
{
#if defined(__clang__) || __GNUC__ >= 12
  return __builtin_shufflevector(a, b, 2 * lane + first...);
#else
  constexpr int lanes = sizeof...(lane);
  return Register{(2 * lane < lanes ? a : b)[(2 * lane + first) % lanes]...};
#endif
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief sets lane i of a, counted through all registers, to the sum of the lanes of a[i]: the
/// lanes are added in pairs, the pairs in pairs, and so on.
///
/// \tparam count a power of two
template <class Real, int count>
CONFORMAL_GEOMETRY_PROCESSING_INLINE void sum_lanes(typename Simd_lanes<Real>::Register (&a)[count])
{
  using Register = typename Simd_lanes<Real>::Register;
  const std::make_integer_sequence<int, Simd_lanes<Real>::size> lanes;
  int left = count;
#pragma GCC unroll 4
  for (int width = Simd_lanes<Real>::size; width > 1; width /= 2) {
    const int step = left > 1 ? 1 : 0;  // a single register is added to itself
    left = left > 1 ? left / 2 : 1;
#pragma GCC unroll 4
    for (int i = 0; i < left; ++i) {
      const Register first = a[i + step * i], second = a[i + step * (i + 1)];
      a[i] = internal::every_other<Register, 0>(first, second, lanes) +
             internal::every_other<Register, 1>(first, second, lanes);
    }
  }
}

}  // namespace Conformal_geometry_processing

#endif
