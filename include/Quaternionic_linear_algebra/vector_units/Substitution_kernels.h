// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/vector_units/Front_kernels.h>
#include <Quaternionic_linear_algebra/vector_units/Simd_lanes.h>
#include <Quaternionic_linear_algebra/vector_units/kernel_arithmetic.h>

#include <cstdint>

namespace Conformal_geometry_processing::internal {

/// \brief Dense kernels for one row block of a supernodal factor and the same number of rows of
/// right-hand sides, for scalars of `planes` real components.
///
/// A row block of the right-hand sides is stored [number][lane], like the accumulators, a row
/// [number].
/// \tparam numbers per row: components of all right-hand sides
template <class Unit, class Real, int planes, int numbers>
class Row_block_kernels {
  using Planes = Plane_products<planes>;
  using Simd = Simd_lanes<Unit, Real>;
  using Register = typename Simd::Register;

 public:
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
  /// acc -= L y for one column of a row block, of numbers as they are stored
  template <class Stored>
  static CGP_ALWAYS_INLINE void subtract(Accumulators& acc, const Stored* L, const Real* y)
  {
    Register a[planes];
    load(L, a);
    CGP_UNROLL(8)
    for (int c = 0; c < columns; ++c) Planes::subtract(acc[c], a, y + c * planes);
  }

  /// acc += conjugate(L) y for one column of a row block
  template <class Stored>
  static CGP_ALWAYS_INLINE void add_conjugate(Accumulators& acc, const Stored* L,
                                              const Accumulators& y)
  {
    Register a[planes];
    load(L, a);
    CGP_UNROLL(8)
    for (int c = 0; c < columns; ++c) Planes::add_conjugate(acc[c], a, y[c]);
  }

  /// y = (y - unit * the sums of the lanes of acc) * inverse
  static CGP_ALWAYS_INLINE void solve_row(const Accumulators& acc, Real unit, Real inverse, Real* y)
  {
    Register totals[numbers];
    CGP_UNROLL(8)
    for (int i = 0; i < numbers; ++i) totals[i] = acc[i / planes][i % planes];
    sum_lanes<Unit, Real>(totals);
    CGP_UNROLL(8)
    for (int i = 0; i < numbers; ++i) {
      const Real total = unit * totals[i / lanes][i % lanes];
      y[i] = (y[i] - total) * inverse;
    }
  }

  /// Inserts a row in its lane
  static CGP_ALWAYS_INLINE void set_lane(Accumulators& z, int lane, const Real* values)
  {
    CGP_UNROLL(8)
    for (int i = 0; i < numbers; ++i) Simd::set_lane(z[i / planes][i % planes], lane, values[i]);
  }

  /// Prefetches further cells: the factor is read only once, so it is not in the cache.
  template <class Stored>
  static CGP_ALWAYS_INLINE void prefetch(const Stored* L)
  {
    constexpr int line = 64 / static_cast<int>(sizeof(Stored));  // numbers in a cache line
    CGP_UNROLL(4)
    for (int i = 0; i < cell; i += line) CGP_PREFETCH(L + i);
  }

 private:
  template <class Stored>
  static CGP_ALWAYS_INLINE void load(const Stored* from, Register (&a)[planes])
  {
    CGP_UNROLL(4)
    for (int q = 0; q < planes; ++q) a[q] = Simd::load(from + q * lanes);
  }
};

/// \brief Substitution of one front by one vector unit; implements `Front_substitution`.
///
/// \tparam numbers per row of the vector: components of all right-hand sides
template <class Unit, class Real, int planes, int numbers>
class Substitution_kernels {
  using Kernels = Row_block_kernels<Unit, Real, planes, numbers>;
  using Accumulators = typename Kernels::Accumulators;
  using Front = Factored_front<Real>;
  static constexpr int lanes = Kernels::lanes, cell = Kernels::cell, wide = Kernels::wide;
  static constexpr int most_blocks = (max_panel_width + lanes - 1) / lanes;

 public:
  static void add_child(const Child_update<Real>& child, int columns, Real* y, Real* below)
  {
    const Real* from = child.numbers;
    const int *place = child.place, *const end = place + child.rows;
    for (; place != end && *place < columns; ++place, from += numbers)
      add_row(y + *place * numbers, from);
    for (; place != end; ++place, from += numbers)
      add_row(below + std::int64_t(*place - columns) * numbers, from);
  }

  static void forward(const Front& front, Real* y, Real* below)
  {
    if constexpr (can_be_rounded)
      if (front.rounded)
        return forward(Rounded{front.rounded, front.units, front.inverses}, front, y, below);
    forward(Plain{front.panel, front.columns}, front, y, below);
  }

  static void backward(const Front& front, Real* y, const Real* x)
  {
    if constexpr (can_be_rounded)
      if (front.rounded)
        return backward(Rounded{front.rounded, front.units, front.inverses}, front, y, x);
    backward(Plain{front.panel, front.columns}, front, y, x);
  }

 private:
  static constexpr bool can_be_rounded = sizeof(Real) == sizeof(float);

  // A panel of numbers.
  struct Plain {
    static constexpr bool has_units = false;
    const Real* L;
    int k;

    CGP_ALWAYS_INLINE Real unit(int) const { return 1; }
    CGP_ALWAYS_INLINE Real inverse(int j) const
    {
      return 1 / L[(j / lanes * k + j) * cell + j % lanes];
    }
  };

  // A panel of whole multiples of units.
  struct Rounded {
    static constexpr bool has_units = true;
    const std::int16_t* L;
    const Real *units, *inverses;

    CGP_ALWAYS_INLINE Real unit(int j) const { return units[j]; }
    CGP_ALWAYS_INLINE Real inverse(int j) const { return inverses[j]; }
  };

  template <class Panel>
  static CGP_ALWAYS_INLINE void forward(const Panel& panel, const Front& front, Real* y,
                                        Real* below)
  {
    alignas(64) Real scaled[Panel::has_units ? max_panel_width * numbers : 1];
    Real* const multiples = Panel::has_units ? scaled : y;
    solve_triangle(panel, front.columns, y, multiples);
    forward_rows(front, rows_below(panel, front), multiples, below);
  }

  template <class Panel>
  static CGP_ALWAYS_INLINE void backward(const Panel& panel, const Front& front, Real* y,
                                         const Real* x)
  {
    alignas(64) Real sums[max_panel_width * wide];
    internal::set_zero(sums, front.columns * wide);
    backward_rows(front, rows_below(panel, front), x, sums);
    solve_conjugate_triangle(panel, front.columns, sums, y);
  }

  static CGP_ALWAYS_INLINE void add_row(Real* to, const Real* from)
  {
    for (int i = 0; i < numbers; ++i) to[i] += from[i];
  }

  // Below the triangle two row blocks are processed at a time if the registers suffice: each
  // right-hand side is loaded half as often, and latencies overlap. The order of operations is the
  // same as one by one.
  template <class Panel>
  static CGP_ALWAYS_INLINE auto rows_below(const Panel& panel, const Front& front)
  {
    const std::int64_t triangle = (front.columns + lanes - 1) / lanes;
    return panel.L + triangle * front.columns * cell;
  }

  template <class Stored>
  static CGP_ALWAYS_INLINE void forward_rows(const Front& front, const Stored* L, const Real* y,
                                             Real* below)
  {
    const int k = front.columns, u = front.rows_below;
    int row = 0;
    if constexpr (Kernels::blocks_at_once > 1)
      for (; row + lanes < u; row += 2 * lanes, L += std::int64_t(2) * k * cell)
        forward_below<2>(L, k, u - row, y, below + std::int64_t(row) * numbers);
    for (; row < u; row += lanes, L += std::int64_t(k) * cell)
      forward_below<1>(L, k, u - row, y, below + std::int64_t(row) * numbers);
  }

  template <class Stored>
  static CGP_ALWAYS_INLINE void backward_rows(const Front& front, const Stored* L, const Real* x,
                                              Real* sums)
  {
    const int k = front.columns, u = front.rows_below;
    int row = 0;
    if constexpr (Kernels::blocks_at_once > 1)
      for (; row + lanes < u; row += 2 * lanes, L += std::int64_t(2) * k * cell)
        backward_below<2>(L, k, front.rows + row, u - row, x, sums);
    for (; row < u; row += lanes, L += std::int64_t(k) * cell)
      backward_below<1>(L, k, front.rows + row, u - row, x, sums);
  }

  // Computes y, and its multiples by the units of the columns unless these are the same numbers.
  template <class Panel>
  static CGP_ALWAYS_INLINE void solve_triangle(const Panel& panel, int k, Real* y, Real* multiples)
  {
    const auto* const L = panel.L;
    const int triangle = (k + lanes - 1) / lanes;
    alignas(64) Real block[most_blocks * wide] = {};
    for (int j = 0; j < k; ++j)
      for (int i = 0; i < numbers; ++i)
        block[j / lanes * wide + i * lanes + j % lanes] = y[j * numbers + i];
    for (int j = 0; j < k; ++j) {
      const int diagonal = j / lanes;
      const Real inverse = panel.inverse(j), scale = panel.unit(j) * inverse;
      const Real* const row = block + diagonal * wide + j % lanes;
      for (int i = 0; i < numbers; ++i) y[j * numbers + i] = row[i * lanes] * inverse;
      if (Panel::has_units)
        for (int i = 0; i < numbers; ++i) multiples[j * numbers + i] = row[i * lanes] * scale;
      for (int b = diagonal; b < triangle; ++b) {
        Accumulators acc;
        Kernels::load(block + b * wide, acc);
        Kernels::subtract(acc, L + (b * k + j) * cell, multiples + j * numbers);
        Kernels::store(block + b * wide, acc);
      }
    }
  }

  template <int blocks, class Stored>
  static CGP_ALWAYS_INLINE void forward_below(const Stored* L, int k, int count, const Real* y,
                                              Real* to)
  {
    const std::int64_t stride = static_cast<std::int64_t>(k) * cell;
    Accumulators acc[blocks] = {};
    for (int j = 0; j < k; ++j, L += cell) {
      CGP_UNROLL(2)
      for (int b = 0; b < blocks; ++b) {
        Kernels::prefetch(L + (blocks + b) * stride);
        Kernels::subtract(acc[b], L + b * stride, y + j * numbers);
      }
    }
    alignas(64) Real sums[blocks * wide];
    for (int b = 0; b < blocks; ++b) Kernels::store(sums + b * wide, acc[b]);
    for (int l = 0; l < internal::least(count, blocks * lanes); ++l)
      for (int i = 0; i < numbers; ++i)
        to[l * numbers + i] += sums[l / lanes * wide + i * lanes + l % lanes];
  }

  // sums_j += conjugate(L_j) x for each column j
  template <int blocks, class Stored>
  static CGP_ALWAYS_INLINE void backward_below(const Stored* L, int k, const int* rows, int count,
                                               const Real* x, Real* sums)
  {
    const std::int64_t stride = static_cast<std::int64_t>(k) * cell;
    alignas(64) Real gathered[blocks * wide] = {};
    for (int l = 0; l < internal::least(count, blocks * lanes); ++l)
      for (int i = 0; i < numbers; ++i)
        gathered[l / lanes * wide + i * lanes + l % lanes] =
            x[static_cast<std::int64_t>(rows[l]) * numbers + i];
    Accumulators z[blocks], acc;
    for (int b = 0; b < blocks; ++b) Kernels::load(gathered + b * wide, z[b]);
    for (int j = 0; j < k; ++j, L += cell) {
      Kernels::load(sums + j * wide, acc);
      CGP_UNROLL(2)
      for (int b = 0; b < blocks; ++b) {
        Kernels::prefetch(L + (blocks + b) * stride);
        Kernels::add_conjugate(acc, L + b * stride, z[b]);
      }
      Kernels::store(sums + j * wide, acc);
    }
  }

  template <class Panel>
  static CGP_ALWAYS_INLINE void solve_conjugate_triangle(const Panel& panel, int k,
                                                         const Real* sums, Real* y)
  {
    const auto* const L = panel.L;
    const int triangle = (k + lanes - 1) / lanes;
    alignas(64) Real block[most_blocks * wide];
    for (int own = triangle - 1; own >= 0; --own) {
      Accumulators z = {};  // the solved part of the row block of column j
      for (int j = internal::least(k, (own + 1) * lanes) - 1; j >= own * lanes; --j) {
        Accumulators acc, later;
        Kernels::load(sums + j * wide, acc);
        for (int b = triangle - 1; b > own; --b) {
          Kernels::load(block + b * wide, later);
          Kernels::add_conjugate(acc, L + (b * k + j) * cell, later);
        }
        Kernels::add_conjugate(acc, L + (own * k + j) * cell, z);
        Kernels::solve_row(acc, panel.unit(j), panel.inverse(j), y + j * numbers);
        Kernels::set_lane(z, j % lanes, y + j * numbers);
      }
      Kernels::store(block + own * wide, z);
    }
  }
};

}  // namespace Conformal_geometry_processing::internal
