// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUBSTITUTION_KERNELS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUBSTITUTION_KERNELS_H

#include <Conformal_geometry_processing/linear_algebra/direct/Front_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/direct/lane_sums.h>

#include <algorithm>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the dense work on one row block of a supernodal factor and as many rows of right-hand
/// sides, for any scalar.
///
/// A row block of the right-hand sides is stored [number][lane], as the accumulators are, a row
/// [number]. \tparam numbers per row: components of all right-hand sides
template <class Scalar, class Real, int numbers>
class Substitution_kernels {
  using Planes = Scalar_planes<Scalar>;
  using Simd = Simd_lanes<Real>;
  using Register = typename Simd::Register;
  static constexpr int planes = Planes::size;

 public:
  static constexpr int line = 64 / static_cast<int>(sizeof(Real));  ///< numbers in a cache line
  static constexpr int lanes = Simd::size;
  static constexpr int cell = Front_kernels<Scalar, Real>::cell;
  static constexpr int columns = numbers / planes;  ///< right-hand sides
  static constexpr int wide = numbers * lanes;      ///< numbers in a row block
  static_assert(columns * planes == numbers);

  /// how many row blocks at once keep their sums to half of the registers, of which there are 32
  /// with AVX-512 and 16 without
  static constexpr int blocks_at_once =
      (std::max)(1, (internal::simd_bytes == 64 ? 16 : 8) / numbers);

  using Accumulators = Register[columns][planes];

  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void load(const Real* from, Accumulators& acc)
  {
#pragma GCC unroll 8
    for (int i = 0; i < numbers; ++i) acc[i / planes][i % planes] = Simd::load(from + i * lanes);
  }
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void store(Real* to, const Accumulators& acc)
  {
#pragma GCC unroll 8
    for (int i = 0; i < numbers; ++i) Simd::store(to + i * lanes, acc[i / planes][i % planes]);
  }
  /// acc -= L y for one column of a row block
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract(Accumulators& acc, const Real* L,
                                                            const Real* y)
  {
    Register a[planes];
    load(L, a);
#pragma GCC unroll 8
    for (int c = 0; c < columns; ++c) Planes::subtract(acc[c], a, y + c * planes);
  }

  /// acc += conjugate(L) y for one column of a row block
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void add_conjugate(Accumulators& acc, const Real* L,
                                                                 const Accumulators& y)
  {
    Register a[planes];
    load(L, a);
#pragma GCC unroll 8
    for (int c = 0; c < columns; ++c) Planes::add_conjugate(acc[c], a, y[c]);
  }

  /// y = (y - the sums of the lanes of acc) * inverse
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void solve_row(const Accumulators& acc, Real inverse,
                                                             Real* y)
  {
    Register totals[numbers];
#pragma GCC unroll 8
    for (int i = 0; i < numbers; ++i) totals[i] = acc[i / planes][i % planes];
    sum_lanes<Real>(totals);
#pragma GCC unroll 8
    for (int i = 0; i < numbers; ++i) y[i] = (y[i] - totals[i / lanes][i % lanes]) * inverse;
  }

  /// puts a row into its lane
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void set_lane(Accumulators& z, int lane,
                                                            const Real* values)
  {
    Register indices;
    for (int l = 0; l < lanes; ++l) indices[l] = static_cast<Real>(l);
    const auto is_there = indices == static_cast<Real>(lane) + Register{};
#pragma GCC unroll 8
    for (int i = 0; i < numbers; ++i) {
      Register& r = z[i / planes][i % planes];
      r = is_there ? values[i] + Register{} : r;
    }
  }

  /// The factor is read once, so it comes from memory: each cell asks for one further on.
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void prefetch(const Real* L)
  {
#pragma GCC unroll 4
    for (int i = 0; i < cell; i += line) __builtin_prefetch(L + i);
  }

 private:
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void load(const Real* from, Register (&a)[planes])
  {
#pragma GCC unroll 4
    for (int q = 0; q < planes; ++q) a[q] = Simd::load(from + q * lanes);
  }
};

}  // namespace Conformal_geometry_processing

#endif
