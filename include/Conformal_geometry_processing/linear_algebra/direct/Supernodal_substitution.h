// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODAL_SUBSTITUTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODAL_SUBSTITUTION_H

#include <Conformal_geometry_processing/linear_algebra/direct/Substitution_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Supernodal_factor.h>
#include <Conformal_geometry_processing/linear_algebra/direct/supernodes.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief solves L L^H x = b for right-hand sides of four or eight numbers per row: so many real
/// ones, half as many complex ones or a quarter of quaternions, which fill the registers equally
/// well.
///
/// The factor comes from memory, so eight numbers take little longer than four. A right-hand side
/// has the same solution to the bit, whatever the others beside it and their number.
///
/// Forward, each front hands the sums for the rows below to its parent, as the factorization does;
/// backward, it reads the rows below. So subtrees are tasks for several threads, with the same
/// results to the bit.
///
/// The vector is stored [row][right-hand side][component], rows in the order of elimination.
///
/// \tparam numbers_ per row, 4 or 8
template <class Scalar, class Real, int numbers_ = 4>
class Supernodal_substitution {
  using Factor = Supernodal_factor<Scalar, Real>;
  using Kernels = Substitution_kernels<Scalar, Real, numbers_>;
  using Accumulators = typename Kernels::Accumulators;
  static constexpr int lanes = Kernels::lanes, cell = Kernels::cell, wide = Kernels::wide;

 public:
  static constexpr int numbers = numbers_;          ///< per row
  static constexpr int columns = Kernels::columns;  ///< right-hand sides at once
  static_assert(numbers == 4 || numbers == 8);

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
    if (m_threads > 1) return m_factor.tasks().run(m_threads, up(x), down(x));
    forward(0, S.size(), x);
    backward(0, S.size(), x);
  }

  /// \brief the first half: b becomes the right-hand side of the kept rows, and L^-1 b above.
  void forward(Real* x)
  {
    if (m_threads > 1)
      m_factor.tasks().run(m_threads, up(x));
    else
      forward(0, S.size(), x);
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
    if (m_threads > 1) return m_factor.tasks().run(m_threads, nothing, down(x));
    backward(0, S.size(), x);
  }

 private:
  static constexpr int most_blocks = (max_supernode_width + lanes - 1) / lanes;

  auto up(Real* x)
  {
    return [this, x](const Elimination_tasks::Task& t, Task_pool&) { forward(t.begin, t.end, x); };
  }
  auto down(Real* x) const
  {
    return [this, x](const Elimination_tasks::Task& t, Task_pool&) { backward(t.begin, t.end, x); };
  }
  void forward(int begin, int end, Real* x)
  {
    for (int s = begin; s < end; ++s) forward(s, x);
  }
  void backward(int begin, int end, Real* x) const
  {
    for (int s = end - 1; s >= begin; --s) backward(s, x);
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
        Kernels::load(block + b * wide, acc);
        Kernels::subtract(acc, L + (b * k + j) * cell, y + j * numbers);
        Kernels::store(block + b * wide, acc);
      }
    }
    const Real* const below = L + static_cast<std::int64_t>(triangle) * k * cell;
    for_row_blocks(below, k, u, [&](auto blocks, const Real* from, int row) {
      forward_below<blocks>(from, k, u - row, y, own + std::int64_t(row) * numbers);
    });
  }

  // Calls visit(number of row blocks, where they begin, their first row) for the rows below, two
  // blocks at a time if the registers hold them: each right-hand side is loaded half as often, and
  // latencies overlap. The order of operations is the same one by one.
  template <class Visitor>
  static void for_row_blocks(const Real* L, int k, int rows, Visitor visit)
  {
    int row = 0;
    if constexpr (Kernels::blocks_at_once > 1)
      for (; row + lanes < rows; row += 2 * lanes, L += std::int64_t(2) * k * cell)
        visit(std::integral_constant<int, 2>(), L, row);
    for (; row < rows; row += lanes, L += std::int64_t(k) * cell)
      visit(std::integral_constant<int, 1>(), L, row);
  }

  // The beginning of a panel that follows against the direction of the memory.
  void prefetch_panel(int s) const
  {
    const std::int64_t size = m_factor.panel(s + 1) - m_factor.panel(s);
    for (std::int64_t i = 0; i < (std::min)(size, std::int64_t(64) * Kernels::line);
         i += Kernels::line)
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
        Kernels::prefetch(L + (blocks + b) * stride);
        Kernels::subtract(acc[b], L + b * stride, y + j * numbers);
      }
    alignas(64) Real sums[blocks * wide];
    for (int b = 0; b < blocks; ++b) Kernels::store(sums + b * wide, acc[b]);
    for (int l = 0; l < (std::min)(count, blocks * lanes); ++l)
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
    alignas(64) Real block[most_blocks * wide];
    for (int own = triangle - 1; own >= 0; --own) {
      Accumulators z = {};  // the row block of column j, as far as it is solved
      for (int j = (std::min)(k, (own + 1) * lanes) - 1; j >= own * lanes; --j) {
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

  // sums_j += conjugate(L_j) x for each column j
  template <int blocks>
  static void backward_below(const Real* L, int k, const int* rows, int count, const Real* x,
                             Real* sums)
  {
    const std::int64_t stride = static_cast<std::int64_t>(k) * cell;
    alignas(64) Real gathered[blocks * wide] = {};
    for (int l = 0; l < (std::min)(count, blocks * lanes); ++l)
      for (int i = 0; i < numbers; ++i)
        gathered[l / lanes * wide + i * lanes + l % lanes] =
            x[static_cast<std::int64_t>(rows[l]) * numbers + i];
    Accumulators z[blocks], acc;
    for (int b = 0; b < blocks; ++b) Kernels::load(gathered + b * wide, z[b]);
    for (int j = 0; j < k; ++j, L += cell) {
      Kernels::load(sums + j * wide, acc);
#pragma GCC unroll 2
      for (int b = 0; b < blocks; ++b) {
        Kernels::prefetch(L + (blocks + b) * stride);
        Kernels::add_conjugate(acc, L + b * stride, z[b]);
      }
      Kernels::store(sums + j * wide, acc);
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
