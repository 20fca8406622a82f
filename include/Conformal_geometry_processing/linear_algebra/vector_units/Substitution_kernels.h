// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_SUBSTITUTION_KERNELS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_SUBSTITUTION_KERNELS_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/Front_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/Row_block_kernels.h>

#include <cstdint>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
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
    const int k = front.columns, u = front.rows_below;
    solve_triangle(front.panel, k, y);
    const Real* L = rows_below(front);
    int row = 0;
    if constexpr (Kernels::blocks_at_once > 1)
      for (; row + lanes < u; row += 2 * lanes, L += std::int64_t(2) * k * cell)
        forward_below<2>(L, k, u - row, y, below + std::int64_t(row) * numbers);
    for (; row < u; row += lanes, L += std::int64_t(k) * cell)
      forward_below<1>(L, k, u - row, y, below + std::int64_t(row) * numbers);
  }

  static void backward(const Front& front, Real* y, const Real* x)
  {
    const int k = front.columns, u = front.rows_below;
    alignas(64) Real sums[max_panel_width * wide];
    internal::set_zero(sums, k * wide);
    const Real* L = rows_below(front);
    int row = 0;
    if constexpr (Kernels::blocks_at_once > 1)
      for (; row + lanes < u; row += 2 * lanes, L += std::int64_t(2) * k * cell)
        backward_below<2>(L, k, front.rows + row, u - row, x, sums);
    for (; row < u; row += lanes, L += std::int64_t(k) * cell)
      backward_below<1>(L, k, front.rows + row, u - row, x, sums);
    solve_conjugate_triangle(front.panel, k, sums, y);
  }

 private:
  static CGP_ALWAYS_INLINE void add_row(Real* to, const Real* from)
  {
    for (int i = 0; i < numbers; ++i) to[i] += from[i];
  }

  // Below the triangle two row blocks are processed at a time if the registers suffice: each
  // right-hand side is loaded half as often, and latencies overlap. The order of operations is the
  // same as one by one.
  static CGP_ALWAYS_INLINE const Real* rows_below(const Front& front)
  {
    const std::int64_t triangle = (front.columns + lanes - 1) / lanes;
    return front.panel + triangle * front.columns * cell;
  }

  static CGP_ALWAYS_INLINE void solve_triangle(const Real* L, int k, Real* y)
  {
    const int triangle = (k + lanes - 1) / lanes;
    alignas(64) Real block[most_blocks * wide] = {};
    for (int j = 0; j < k; ++j)
      for (int i = 0; i < numbers; ++i)
        block[j / lanes * wide + i * lanes + j % lanes] = y[j * numbers + i];
    for (int j = 0; j < k; ++j) {
      const int diagonal = j / lanes;
      const Real inverse = 1 / L[(diagonal * k + j) * cell + j % lanes];
      for (int i = 0; i < numbers; ++i)
        y[j * numbers + i] = block[diagonal * wide + i * lanes + j % lanes] * inverse;
      for (int b = diagonal; b < triangle; ++b) {
        Accumulators acc;
        Kernels::load(block + b * wide, acc);
        Kernels::subtract(acc, L + (b * k + j) * cell, y + j * numbers);
        Kernels::store(block + b * wide, acc);
      }
    }
  }

  template <int blocks>
  static CGP_ALWAYS_INLINE void forward_below(const Real* L, int k, int count, const Real* y,
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
  template <int blocks>
  static CGP_ALWAYS_INLINE void backward_below(const Real* L, int k, const int* rows, int count,
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

  static CGP_ALWAYS_INLINE void solve_conjugate_triangle(const Real* L, int k, const Real* sums,
                                                         Real* y)
  {
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
        Kernels::solve_row(acc, 1 / L[(own * k + j) * cell + j % lanes], y + j * numbers);
        Kernels::set_lane(z, j % lanes, y + j * numbers);
      }
      Kernels::store(block + own * wide, z);
    }
  }
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#endif
