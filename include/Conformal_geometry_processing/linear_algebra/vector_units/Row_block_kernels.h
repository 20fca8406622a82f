// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_ROW_BLOCK_KERNELS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_ROW_BLOCK_KERNELS_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/Plane_products.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/lane_sums.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/plain_functions.h>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Dense kernels for one row block of a supernodal factor and the same number of rows of
/// right-hand sides, for scalars of `planes` real components.
///
/// A row block of the right-hand sides is stored [number][lane], like the accumulators, a row
/// [number]. \tparam numbers per row: components of all right-hand sides
template <class Unit, class Real, int planes, int numbers>
class Row_block_kernels {
  using Planes = Plane_products<planes>;
  using Simd = Simd_lanes<Unit, Real>;
  using Register = typename Simd::Register;

 public:
  static constexpr int line = 64 / static_cast<int>(sizeof(Real));  ///< numbers in a cache line
  static constexpr int lanes = Simd::size;
  static constexpr int cell = planes * lanes;
  static constexpr int columns = numbers / planes;  ///< right-hand sides
  static constexpr int wide = numbers * lanes;      ///< numbers in a row block
  static_assert(columns * planes == numbers);

  /// Number of row blocks whose accumulators fit in half of the registers
  static constexpr int blocks_at_once = internal::greatest(1, Unit::registers / 2 / numbers);

  using Accumulators = Register[columns][planes];

  static CGP_ALWAYS_INLINE void load(const Real* from, Accumulators& acc)
  {
    CGP_UNROLL(8)
    for (int i = 0; i < numbers; ++i) acc[i / planes][i % planes] = Simd::load(from + i * lanes);
  }
  static CGP_ALWAYS_INLINE void store(Real* to, const Accumulators& acc)
  {
    CGP_UNROLL(8)
    for (int i = 0; i < numbers; ++i) Simd::store(to + i * lanes, acc[i / planes][i % planes]);
  }
  /// acc -= L y for one column of a row block
  static CGP_ALWAYS_INLINE void subtract(Accumulators& acc, const Real* L, const Real* y)
  {
    Register a[planes];
    load(L, a);
    CGP_UNROLL(8)
    for (int c = 0; c < columns; ++c) Planes::subtract(acc[c], a, y + c * planes);
  }

  /// acc += conjugate(L) y for one column of a row block
  static CGP_ALWAYS_INLINE void add_conjugate(Accumulators& acc, const Real* L,
                                              const Accumulators& y)
  {
    Register a[planes];
    load(L, a);
    CGP_UNROLL(8)
    for (int c = 0; c < columns; ++c) Planes::add_conjugate(acc[c], a, y[c]);
  }

  /// y = (y - the sums of the lanes of acc) * inverse
  static CGP_ALWAYS_INLINE void solve_row(const Accumulators& acc, Real inverse, Real* y)
  {
    Register totals[numbers];
    CGP_UNROLL(8)
    for (int i = 0; i < numbers; ++i) totals[i] = acc[i / planes][i % planes];
    sum_lanes<Unit, Real>(totals);
    CGP_UNROLL(8)
    for (int i = 0; i < numbers; ++i) y[i] = (y[i] - totals[i / lanes][i % lanes]) * inverse;
  }

  /// Inserts a row in its lane
  static CGP_ALWAYS_INLINE void set_lane(Accumulators& z, int lane, const Real* values)
  {
    CGP_UNROLL(8)
    for (int i = 0; i < numbers; ++i) Simd::set_lane(z[i / planes][i % planes], lane, values[i]);
  }

  /// Prefetches further cells: the factor is read only once, so it is not in the cache.
  static CGP_ALWAYS_INLINE void prefetch(const Real* L)
  {
    CGP_UNROLL(4)
    for (int i = 0; i < cell; i += line) CGP_PREFETCH(L + i);
  }

 private:
  static CGP_ALWAYS_INLINE void load(const Real* from, Register (&a)[planes])
  {
    CGP_UNROLL(4)
    for (int q = 0; q < planes; ++q) a[q] = Simd::load(from + q * lanes);
  }
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#endif
