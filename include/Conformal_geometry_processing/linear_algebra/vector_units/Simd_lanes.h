// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_SIMD_LANES_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_SIMD_LANES_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/Lane_array.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/Panel_layout.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/unit_tags.h>

namespace Conformal_geometry_processing {
namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief A register of the unit, with elementwise arithmetic.
///
/// \tparam Unit one of the file unit_tags.h
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

}  // namespace internal

}  // namespace Conformal_geometry_processing

#endif
