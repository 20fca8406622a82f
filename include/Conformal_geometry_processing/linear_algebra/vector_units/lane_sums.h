// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_LANE_SUMS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_LANE_SUMS_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/Simd_lanes.h>

namespace Conformal_geometry_processing {

namespace internal {

template <int... lane>
struct Lane_list {};

/// \cond a recursion that Doxygen reports as an error
// 0, 1, ..., count - 1
template <int count, int... lane>
struct Lanes_up_to : Lanes_up_to<count - 1, count - 1, lane...> {};
template <int... lane>
struct Lanes_up_to<0, lane...> {
  using List = Lane_list<lane...>;
};
/// \endcond

// Lanes first, first + 2, ... of a and then of b, by one instruction if the compiler supports it.
template <int first, class Register, int... lane>
CGP_ALWAYS_INLINE Register every_other(const Register& a, const Register& b, Lane_list<lane...>)
{
#if defined(CGP_HAS_VECTOR_EXTENSIONS) && (defined(__clang__) || __GNUC__ >= 12)
  return __builtin_shufflevector(a, b, 2 * lane + first...);
#else
  constexpr int lanes = sizeof...(lane);
  return Register{(2 * lane < lanes ? a : b)[(2 * lane + first) % lanes]...};
#endif
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Sets lane i of a, counted through all registers, to the sum of the lanes of a[i], by
/// pairwise summation.
///
/// \tparam count a power of two
template <class Unit, class Real, int count>
CGP_ALWAYS_INLINE void sum_lanes(typename internal::Simd_lanes<Unit, Real>::Register (&a)[count])
{
  using Register = typename internal::Simd_lanes<Unit, Real>::Register;
  constexpr int lanes = internal::Simd_lanes<Unit, Real>::size;
  const typename internal::Lanes_up_to<lanes>::List all{};
  int left = count;
  CGP_UNROLL(4)
  for (int width = lanes; width > 1; width /= 2) {
    const int step = left > 1 ? 1 : 0;  // a single register is added to itself
    left = left > 1 ? left / 2 : 1;
    CGP_UNROLL(4)
    for (int i = 0; i < left; ++i) {
      const Register first = a[i + step * i], second = a[i + step * (i + 1)];
      a[i] = internal::every_other<0>(first, second, all) +
             internal::every_other<1>(first, second, all);
    }
  }
}

}  // namespace Conformal_geometry_processing

#endif
