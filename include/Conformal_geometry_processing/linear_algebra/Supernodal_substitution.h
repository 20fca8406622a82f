// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SUPERNODAL_SUBSTITUTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_SUPERNODAL_SUBSTITUTION_H

#include <Conformal_geometry_processing/linear_algebra/Supernodal_factor.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief solves L L^H x = b for right-hand sides of four numbers per row: four real ones, two
/// complex ones or one of quaternions, which fill the registers equally well.
///
/// Forward, each front hands the sums for the rows below to its parent, as the factorization does;
/// backward, it reads the rows below. So subtrees are tasks for several threads, with the same
/// results to the bit.
///
/// The vector is stored [row][right-hand side][component], rows in the order of elimination.
template <class Scalar, class Real>
class Supernodal_substitution {
  using Factor = Supernodal_factor<Scalar, Real>;
  using Planes = Scalar_planes<Scalar>;
  using Simd = Simd_lanes<Real>;
  using Register = typename Simd::Register;
  static constexpr int lanes = Factor::Kernels::lanes, cell = Factor::Kernels::cell;
  static constexpr int planes = Planes::size;
  static constexpr int line = 64 / static_cast<int>(sizeof(Real));  // numbers in a cache line

 public:
  static constexpr int numbers = 4;                 ///< per row
  static constexpr int columns = numbers / planes;  ///< right-hand sides at once

  /// \throw std::bad_alloc
  explicit Supernodal_substitution(const Factor& factor)
      : m_factor(factor),
        S(factor.structure()),
        m_threads(Factor::threads(static_cast<double>(factor.panel_bytes()) / 5e9))  // read twice
  {
    const auto size = [&](int s) { return static_cast<std::int64_t>(S.height(s)) * numbers; };
    m_places = m_threads > 1 ? Update_places(S, factor.tasks(), size) : Update_places(S, size);
    m_updates.resize(m_places.size());
  }

  /// b, `numbers` * |V| of them, becomes x
  void solve(Real* x)
  {
    const auto up = [&](const Elimination_tasks::Task& task, Task_pool&) {
      for (int s = task.begin; s < task.end; ++s) forward(s, x);
    };
    const auto down = [&](const Elimination_tasks::Task& task, Task_pool&) {
      for (int s = task.end - 1; s >= task.begin; --s) backward(s, x);
    };
    if (m_threads > 1) return m_factor.tasks().run(m_threads, up, down);
    for (int s = 0; s < S.size(); ++s) forward(s, x);
    for (int s = S.size() - 1; s >= 0; --s) backward(s, x);
  }

  /// \brief the first half: b becomes the right-hand side of the kept rows, and L^-1 b above.
  void forward(Real* x)
  {
    const auto up = [&](const Elimination_tasks::Task& task, Task_pool&) {
      for (int s = task.begin; s < task.end; ++s) forward(s, x);
    };
    if (m_threads > 1)
      m_factor.tasks().run(m_threads, up);
    else
      for (int s = 0; s < S.size(); ++s) forward(s, x);
    for (int s = 0; s < S.size(); ++s)
      if (S.parent(s) < 0)
        for (int i = 0; i < S.height(s); ++i)
          add_row(x + std::int64_t(S.rows(s)[i]) * numbers,
                  m_updates.data() + m_places[s] + std::int64_t(i) * numbers);
  }

  /// \brief the second half, where the kept rows are solutions already.
  void backward(Real* x) const
  {
    const auto nothing = [](const Elimination_tasks::Task&, Task_pool&) {};
    const auto down = [&](const Elimination_tasks::Task& task, Task_pool&) {
      for (int s = task.end - 1; s >= task.begin; --s) backward(s, x);
    };
    if (m_threads > 1) return m_factor.tasks().run(m_threads, nothing, down);
    for (int s = S.size() - 1; s >= 0; --s) backward(s, x);
  }

 private:
  static constexpr int wide = numbers * lanes;  // a row block of the vector, [number][lane]
  static constexpr int most_blocks = (max_supernode_width + lanes - 1) / lanes;
  using Accumulators = Register[columns][planes];

  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void load(const Real* from, Accumulators& acc)
  {
#pragma GCC unroll 4
    for (int i = 0; i < numbers; ++i) acc[i / planes][i % planes] = Simd::load(from + i * lanes);
  }
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void store(Real* to, const Accumulators& acc)
  {
#pragma GCC unroll 4
    for (int i = 0; i < numbers; ++i) Simd::store(to + i * lanes, acc[i / planes][i % planes]);
  }
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void load(const Real* from, Register (&a)[planes])
  {
#pragma GCC unroll 4
    for (int q = 0; q < planes; ++q) a[q] = Simd::load(from + q * lanes);
  }

  // acc -= L y for one column of a row block
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract(Accumulators& acc, const Real* L,
                                                            const Real* y)
  {
    Register a[planes];
    load(L, a);
#pragma GCC unroll 4
    for (int c = 0; c < columns; ++c) Planes::subtract(acc[c], a, y + c * planes);
  }

  // acc += conjugate(L) y for one column of a row block
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void add_conjugate(Accumulators& acc, const Real* L,
                                                                 const Accumulators& y)
  {
    Register a[planes];
    load(L, a);
#pragma GCC unroll 4
    for (int c = 0; c < columns; ++c) Planes::add_conjugate(acc[c], a, y[c]);
  }

  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void add_row(Real* to, const Real* from)
  {
    for (int i = 0; i < numbers; ++i) to[i] += from[i];
  }

  // What the children hand over goes to the rows y of the front, and to those below.
  void add_children(int s, Real* y, Real* below) const
  {
    const int k = S.width(s);
    for (const int* c = S.children_begin(s); c != S.children_end(s); ++c) {
      const Real* from = m_updates.data() + m_places[*c];
      const int *place = S.relative_rows(*c), *const end = place + S.height(*c);
      for (; place != end && *place < k; ++place, from += numbers)
        add_row(y + *place * numbers, from);
      for (; place != end; ++place, from += numbers)
        add_row(below + std::int64_t(*place - k) * numbers, from);
    }
  }

  void forward(int s, Real* x)
  {
    const int k = S.width(s), u = S.height(s), triangle = Factor::Kernels::blocks(k);
    const Real* const L = m_factor.panel(s);
    Real* const y = x + static_cast<std::int64_t>(S.first(s)) * numbers;
    Real* const own = m_updates.data() + m_places[s];
    std::fill_n(own, std::int64_t(u) * numbers, Real(0));
    add_children(s, y, own);
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
        load(block + b * wide, acc);
        subtract(acc, L + (b * k + j) * cell, y + j * numbers);
        store(block + b * wide, acc);
      }
    }
    const Real* const below = L + static_cast<std::int64_t>(triangle) * k * cell;
    for_row_blocks(below, k, u, [&](auto blocks, const Real* from, int row) {
      forward_below<blocks>(from, k, u - row, y, own + std::int64_t(row) * numbers);
    });
  }

  // Calls visit(number of row blocks, where they begin, their first row) for the rows below, two
  // blocks at a time: each right-hand side is loaded half as often, and latencies overlap.
  template <class Visitor>
  static void for_row_blocks(const Real* L, int k, int rows, Visitor visit)
  {
    int row = 0;
    for (; row + lanes < rows; row += 2 * lanes, L += std::int64_t(2) * k * cell)
      visit(std::integral_constant<int, 2>(), L, row);
    if (row < rows) visit(std::integral_constant<int, 1>(), L, row);
  }

  // The factor is read once, so it comes from memory: each cell asks for one further on.
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void prefetch(const Real* L)
  {
#pragma GCC unroll 4
    for (int i = 0; i < cell; i += line) __builtin_prefetch(L + i);
  }

  // The beginning of a panel that follows against the direction of the memory.
  void prefetch_panel(int s) const
  {
    const std::int64_t size = m_factor.panel(s + 1) - m_factor.panel(s);
    for (std::int64_t i = 0; i < std::min(size, std::int64_t(64) * line); i += line)
      __builtin_prefetch(m_factor.panel(s) + i);
    __builtin_prefetch(S.rows(s));
  }

  template <int blocks>
  static void forward_below(const Real* L, int k, int count, const Real* y, Real* to)
  {
    const std::int64_t stride = static_cast<std::int64_t>(k) * cell;
    Accumulators acc[blocks] = {};
    for (int j = 0; j < k; ++j, L += cell)
#pragma GCC unroll 2
      for (int b = 0; b < blocks; ++b) {
        prefetch(L + (blocks + b) * stride);
        subtract(acc[b], L + b * stride, y + j * numbers);
      }
    alignas(64) Real sums[blocks * wide];
    for (int b = 0; b < blocks; ++b) store(sums + b * wide, acc[b]);
    for (int l = 0; l < std::min(count, blocks * lanes); ++l)
      for (int i = 0; i < numbers; ++i)
        to[l * numbers + i] += sums[l / lanes * wide + i * lanes + l % lanes];
  }

  void backward(int s, Real* x) const
  {
    const int k = S.width(s), triangle = Factor::Kernels::blocks(k);
    const Real* const L = m_factor.panel(s);
    Real* const y = x + static_cast<std::int64_t>(S.first(s)) * numbers;
    alignas(64) Real sums[max_supernode_width * wide];
    std::fill_n(sums, k * wide, Real(0));
    if (s > 0) prefetch_panel(s - 1);
    const Real* const below = L + static_cast<std::int64_t>(triangle) * k * cell;
    for_row_blocks(below, k, S.height(s), [&](auto blocks, const Real* from, int row) {
      backward_below<blocks>(from, k, S.rows(s) + row, S.height(s) - row, x, sums);
    });
    alignas(64) Real block[most_blocks * wide] = {};
    for (int j = k - 1; j >= 0; --j) {
      const int diagonal = j / lanes;
      Accumulators acc, z;
      load(sums + j * wide, acc);
      for (int b = diagonal; b < triangle; ++b) {
        load(block + b * wide, z);
        add_conjugate(acc, L + (b * k + j) * cell, z);
      }
      const Real inverse = 1 / L[(diagonal * k + j) * cell + j % lanes];
      for (int i = 0; i < numbers; ++i) {
        Real sum = 0;
        for (int l = 0; l < lanes; ++l) sum += acc[i / planes][i % planes][l];
        Real& value = y[j * numbers + i];
        value = (value - sum) * inverse;
        block[diagonal * wide + i * lanes + j % lanes] = value;
      }
    }
  }

  // sums_j += conjugate(L_j) x for each column j
  template <int blocks>
  static void backward_below(const Real* L, int k, const int* rows, int count, const Real* x,
                             Real* sums)
  {
    const std::int64_t stride = static_cast<std::int64_t>(k) * cell;
    alignas(64) Real gathered[blocks * wide] = {};
    for (int l = 0; l < std::min(count, blocks * lanes); ++l)
      for (int i = 0; i < numbers; ++i)
        gathered[l / lanes * wide + i * lanes + l % lanes] =
            x[static_cast<std::int64_t>(rows[l]) * numbers + i];
    Accumulators z[blocks], acc;
    for (int b = 0; b < blocks; ++b) load(gathered + b * wide, z[b]);
    for (int j = 0; j < k; ++j, L += cell) {
      load(sums + j * wide, acc);
#pragma GCC unroll 2
      for (int b = 0; b < blocks; ++b) {
        prefetch(L + (blocks + b) * stride);
        add_conjugate(acc, L + b * stride, z[b]);
      }
      store(sums + j * wide, acc);
    }
  }

  const Factor& m_factor;
  const Supernodal_structure& S;
  int m_threads;
  Update_places m_places;
  Aligned_array<Real> m_updates;
};

}  // namespace Conformal_geometry_processing

#endif
