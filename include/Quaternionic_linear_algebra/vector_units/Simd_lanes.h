// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/vector_units/Front_kernels.h>
#include <Quaternionic_linear_algebra/vector_units/kernel_arithmetic.h>

#include <cstdint>

namespace Conformal_geometry_processing {
namespace internal {

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

#ifdef CGP_HAS_VECTOR_EXTENSIONS
// A template, because compilers drop the attribute from a type that does not depend on one.
template <class Number, int size>
struct Register_of {
  typedef Number Type __attribute__((vector_size(size * sizeof(Number)), may_alias));
};
#endif

/// \brief A register of the unit, with elementwise arithmetic.
///
/// \tparam Unit one of the tags in Front_kernels.h
template <class Unit, class Real>
struct Simd_lanes {
  static constexpr int size = Unit::bytes / static_cast<int>(sizeof(Real));

  /// Layout of panels with a row block for every register
  static CGP_ALWAYS_INLINE constexpr Panel_layout layout(int planes)
  {
    return {planes, log2(size)};
  }

#ifdef CGP_HAS_VECTOR_EXTENSIONS
  typedef Real Register __attribute__((vector_size(Unit::bytes)));

  // Memory must be aligned to registers for `load()` and `store()`.
  static CGP_ALWAYS_INLINE Register load(const Real* p)
  {
    return *reinterpret_cast<const Aliasing*>(p);
  }
  static CGP_ALWAYS_INLINE void store(Real* p, const Register& v)
  {
    *reinterpret_cast<Aliasing*>(p) = v;
  }

  /// Converts whole numbers
  static CGP_ALWAYS_INLINE Register load(const std::int16_t* p)
  {
#if defined(__clang__) || __GNUC__ >= 9
    using Short = typename Register_of<std::int16_t, size>::Type;
    using Long = typename Register_of<std::int32_t, size>::Type;
    return __builtin_convertvector(
        __builtin_convertvector(*reinterpret_cast<const Short*>(p), Long), Register);
#else
    Register v;
    for (int l = 0; l < size; ++l) v[l] = p[l];
    return v;
#endif
  }

  /// Sets one lane, without a store to memory
  static CGP_ALWAYS_INLINE void set_lane(Register& v, int lane, Real value)
  {
    Register indices;
    for (int l = 0; l < size; ++l) indices[l] = static_cast<Real>(l);
    v = indices == static_cast<Real>(lane) + Register{} ? value + Register{} : v;
  }

  typedef Real Aliasing __attribute__((vector_size(Unit::bytes), may_alias));

#else
  using Register = Lane_array<Unit, Real, size>;

  static CGP_ALWAYS_INLINE Register load(const Real* p)
  {
    Register v;
    for (int l = 0; l < size; ++l) v[l] = p[l];
    return v;
  }
  static CGP_ALWAYS_INLINE Register load(const std::int16_t* p)
  {
    Register v;
    for (int l = 0; l < size; ++l) v[l] = p[l];
    return v;
  }
  static CGP_ALWAYS_INLINE void store(Real* p, const Register& v)
  {
    for (int l = 0; l < size; ++l) p[l] = v[l];
  }
  static CGP_ALWAYS_INLINE void set_lane(Register& v, int lane, Real value)
  {
    v[lane] = value;
  }
#endif

 private:
  static CGP_ALWAYS_INLINE constexpr int log2(int n)
  {
    int log = 0;
    while (n >> log > 1) ++log;
    return log;
  }
};

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
