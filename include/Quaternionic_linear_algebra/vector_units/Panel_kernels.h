// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/vector_units/Front_kernels.h>
#include <Quaternionic_linear_algebra/vector_units/Simd_lanes.h>
#include <Quaternionic_linear_algebra/vector_units/kernel_arithmetic.h>

#include <cstdint>

namespace Conformal_geometry_processing::internal {

/// \brief Cholesky factor of a diagonal block of at most `group` columns
template <class Unit, class Real, int planes>
class Pivot_triangle {
  using Simd = Simd_lanes<Unit, Real>;
  using Register = typename Simd::Register;
  using Planes = Plane_products<planes>;
  static constexpr int lanes = Simd::size;
  static constexpr int cell = planes * lanes;

 public:
  /// Columns per kernel call: as many as keep the accumulators in half of the registers.
  static constexpr int group =
      internal::least(lanes, internal::greatest(1, Unit::registers / 2 / planes));
  static_assert(lanes % group == 0);

  /// Factors the block in the lanes of the accumulators; returns the first bad pivot, -1 if none
  int factor(const Register (&acc)[group][planes], int lane, int width)
  {
    for (int c = 0; c < width; ++c)
      for (int r = c; r < width; ++r)
        for (int q = 0; q < planes; ++q) m[r][c][q] = acc[c][q][lane + r];
    for (int c = 0; c < width; ++c) {
      for (int e = 0; e < c; ++e)
        for (int r = c; r < width; ++r) Planes::subtract_conjugated(m[r][c], m[r][e], m[c][e]);
      const Real pivot = m[c][c][0];
      if (!internal::is_good_pivot(pivot)) return c;
      const Real root = internal::square_root(pivot);
      m_inverse[c] = 1 / root;
      for (int q = 0; q < planes; ++q) m[c][c][q] = q == 0 ? root : Real(0);
      for (int r = c + 1; r < width; ++r)
        for (int q = 0; q < planes; ++q) m[r][c][q] *= m_inverse[c];
    }
    return -1;
  }

  /// Reads a block that `write()` has stored
  void read(const Real* from, int lane, int width)
  {
    for (int c = 0; c < width; ++c) {
      for (int r = c; r < width; ++r)
        for (int q = 0; q < planes; ++q) m[r][c][q] = from[c * cell + q * lanes + lane + r];
      m_inverse[c] = 1 / m[c][c][0];
    }
  }

  /// Computes acc <- acc L^-H, for the rows below
  CGP_ALWAYS_INLINE void solve(Register (&acc)[group][planes], int width) const
  {
    for (int c = 0; c < width; ++c) {
      for (int d = 0; d < c; ++d) Planes::subtract_conjugated(acc[c], acc[d], m[c][d]);
      for (int q = 0; q < planes; ++q) acc[c][q] *= m_inverse[c];
    }
  }

  /// Stores the block in its row block: exact, with zeros above the diagonal
  void write(Real* to, int lane, int width) const
  {
    for (int c = 0; c < width; ++c)
      for (int q = 0; q < planes; ++q)
        for (int r = -lane; r < width; ++r)
          to[c * cell + q * lanes + lane + r] = r >= c ? m[r][c][q] : Real(0);
  }

 private:
  Real m[group][group][planes];
  Real m_inverse[group];
};

/// \brief Elimination of one front by one vector unit, for scalars of `planes` real components;
/// implements functions of `Front_kernels`.
///
/// All functions use one microkernel: registers of several columns minus a panel times the
/// conjugate of another.
template <class Unit, class Real, int planes>
class Panel_kernels {
  using Simd = Simd_lanes<Unit, Real>;
  using Register = typename Simd::Register;
  using Triangle = Pivot_triangle<Unit, Real, planes>;

 public:
  static constexpr int lanes = Simd::size;
  static constexpr int cell = planes * lanes;  ///< numbers per row block and column

  /// \brief Replaces the panel A = (A11; A21) by L11 with A11 = L11 L11^H and L21 = A21 L11^-H.
  /// \param row_blocks of the panel; if only those of the triangle, `solve_below()` computes the
  /// rest
  /// \returns the first column whose pivot is not positive, -1 if all are
  static int factor_panel(Real* panel, int columns, int row_blocks)
  {
    for (int j = 0; j < columns; j += group) {
      const int width = internal::least(group, columns - j), diagonal = j / lanes, lane = j % lanes;
      Triangle triangle;
      Register acc[group][planes];
      Real* const corner = panel + place(columns, diagonal, j);
      load(corner, width, acc);
      subtract_earlier(acc, panel, columns, diagonal, j);
      const int bad = triangle.factor(acc, lane, width);
      if (bad >= 0) return j + bad;
      triangle.solve(acc, width);
      store(corner, width, acc);
      triangle.write(corner, lane, width);
      solve_columns(panel, columns, j, triangle, diagonal + 1, row_blocks);
    }
    return -1;
  }

  /// \brief Computes L21 in the row blocks begin <= block < end below a factored triangle.
  static void solve_below(Real* panel, int columns, int begin, int end)
  {
    for (int j = 0; j < columns; j += group) {
      const int width = internal::least(group, columns - j), diagonal = j / lanes;
      Triangle triangle;
      triangle.read(panel + place(columns, diagonal, j), j % lanes, width);
      solve_columns(panel, columns, j, triangle, begin, end);
    }
  }

  /// \brief Computes update = -L21 L21^H in the row blocks begin <= block < end of its lower
  /// triangle.
  /// \param below the row blocks of the panel under its triangle
  static void set_outer_product(Real* update, const Real* below, int columns, int rows, int begin,
                                int end)
  {
    const int nb = layout.blocks(rows);
    const std::int64_t stride = static_cast<std::int64_t>(columns) * cell;
    for (int jb = 0; jb < end; ++jb)
      for (int ib = internal::greatest(jb, begin); ib < end; ++ib)
        for (int c = 0; c < internal::least(lanes, rows - jb * lanes); c += group) {
          Register acc[group][planes] = {};
          subtract_products(acc, below + ib * stride, below + jb * stride + c, columns);
          store(update + layout.tile(nb, ib, jb) + c * cell, group, acc);
        }
  }

  /// \brief Rounds to whole multiples of units, see `Front_kernels`.
  static void round_panel(Real* panel, int columns, int row_blocks, std::int16_t* rounded,
                          Real* units, Real* inverses)
  {
    const std::int64_t stride = static_cast<std::int64_t>(columns) * cell;
    for (int j = 0; j < columns; ++j) {
      const int diagonal = j / lanes, lane = j % lanes;
      Real* const corner = panel + place(columns, diagonal, j);
      inverses[j] = 1 / corner[lane];
      for (int q = 0; q < planes; ++q) internal::set_zero(corner + q * lanes, lane + 1);
      std::int16_t* const to = rounded + place(columns, diagonal, j);
      const int blocks = row_blocks - diagonal;
      Real rest[cell] = {};
      units[j] = round_column(corner, stride, blocks, to, rest);
      const bool is_next_here = j + 1 < columns && lane + 1 < lanes;
      if (is_next_here || blocks > 1) add_rest(rest, to + (is_next_here ? lane + 1 : stride));
    }
  }

 private:
  using Planes = Plane_products<planes>;
  static constexpr Panel_layout layout = Simd::layout(planes);
  static constexpr int group = Triangle::group;  // columns per kernel call

  static constexpr int most_units = 32000, most_added = 700;  // fit in 16 bits together

  // Rounds a column of some row blocks and adds to the rest what is left of it; returns its unit.
  static CGP_ALWAYS_INLINE Real round_column(const Real* column, std::int64_t stride, int blocks,
                                             std::int16_t* rounded, Real* rest)
  {
    const Real largest = largest_of(column, stride, blocks);
    const Real inverse = largest > Real(1e-30) ? most_units / largest : Real(0);
    for (int b = 0; b < blocks; ++b)
      for (int i = 0; i < cell; ++i) {
        const Real x = column[b * stride + i] * inverse;
        const int number = nearest(x);
        rounded[b * stride + i] = static_cast<std::int16_t>(number);
        rest[i] += x - static_cast<Real>(number);
      }
    return largest / most_units;
  }

  // Gives the sum of the rest to one row: columns keep their sums, which smooth vectors see.
  static CGP_ALWAYS_INLINE void add_rest(Real* rest, std::int16_t* row)
  {
    for (int half = lanes / 2; half > 0; half /= 2)
      for (int q = 0; q < planes; ++q)
        for (int l = 0; l < half; ++l) rest[q * lanes + l] += rest[q * lanes + l + half];
    for (int q = 0; q < planes; ++q) {
      const int sum = nearest(rest[q * lanes]);
      const int added = internal::greatest(-most_added, internal::least(most_added, sum));
      row[q * lanes] = static_cast<std::int16_t>(row[q * lanes] + added);
    }
  }

  static CGP_ALWAYS_INLINE int nearest(Real x)
  {
    return static_cast<int>(x < 0 ? x - Real(0.5) : x + Real(0.5));
  }

  // The largest absolute value of a column in some row blocks.
  static CGP_ALWAYS_INLINE Real largest_of(const Real* column, std::int64_t stride, int blocks)
  {
    Real largest[cell] = {};  // of each lane, which processors compare at once
    for (int b = 0; b < blocks; ++b)
      for (int i = 0; i < cell; ++i) {
        const Real x = column[b * stride + i], size = x < 0 ? -x : x;
        largest[i] = largest[i] < size ? size : largest[i];
      }
    for (int half = cell / 2; half > 0; half /= 2)
      for (int i = 0; i < half; ++i) largest[i] = internal::greatest(largest[i], largest[i + half]);
    return largest[0];
  }

  static CGP_ALWAYS_INLINE std::int64_t place(int columns, int block, int column)
  {
    return (static_cast<std::int64_t>(block) * columns + column) * cell;
  }

  // Subtracts the contributions of the columns before j to the row block.
  static CGP_ALWAYS_INLINE void subtract_earlier(Register (&acc)[group][planes], const Real* panel,
                                                 int columns, int block, int j)
  {
    subtract_products(acc, panel + place(columns, block, 0),
                      panel + place(columns, j / lanes, 0) + j % lanes, j);
  }

  // Solves columns j, j + 1, ... of the row blocks begin <= block < end.
  static CGP_ALWAYS_INLINE void solve_columns(Real* panel, int columns, int j,
                                              const Triangle& triangle, int begin, int end)
  {
    const int width = internal::least(group, columns - j);
    Register acc[group][planes];
    for (int block = begin; block < end; ++block) {
      Real* const cells = panel + place(columns, block, j);
      load(cells, width, acc);
      subtract_earlier(acc, panel, columns, block, j);
      triangle.solve(acc, width);
      store(cells, width, acc);
    }
  }

  static CGP_ALWAYS_INLINE void load(const Real* from, int width, Register (&acc)[group][planes])
  {
    CGP_UNROLL(16)
    for (int c = 0; c < group; ++c) {
      CGP_UNROLL(4)
      for (int q = 0; q < planes; ++q)
        acc[c][q] = c < width ? Simd::load(from + c * cell + q * lanes) : Register{};
    }
  }

  static CGP_ALWAYS_INLINE void store(Real* to, int width, const Register (&acc)[group][planes])
  {
    for (int c = 0; c < width; ++c) {
      CGP_UNROLL(4)
      for (int q = 0; q < planes; ++q) Simd::store(to + c * cell + q * lanes, acc[c][q]);
    }
  }

  /// The microkernel: acc_c -= sum over the first `count` columns p of A_p conjugate(B_p,c), where
  /// B points to the lane of the first of the `group` rows of B
  static CGP_ALWAYS_INLINE void subtract_products(Register (&acc)[group][planes], const Real* A,
                                                  const Real* B, int count)
  {
    for (int p = 0; p < count; ++p, A += cell, B += cell) {
      Register a[planes];
      CGP_UNROLL(4)
      for (int q = 0; q < planes; ++q) a[q] = Simd::load(A + q * lanes);
      CGP_UNROLL(16)
      for (int c = 0; c < group; ++c) {
        Real b[planes];
        CGP_UNROLL(4)
        for (int q = 0; q < planes; ++q) b[q] = B[q * lanes + c];
        Planes::subtract_conjugated(acc[c], a, b);
      }
    }
  }
};

/// \brief Extend-add operation: adds the update of a child to the front of its parent. Some columns
/// belong to the panel of the parent, the others to its own update (see `Panel_layout`).
///
/// A list of positions maps rows of the child to rows of the front, so numbers are scattered
/// individually. Only rows of the front between two bounds are processed, so that parts of a front
/// can be updated concurrently: each number is the same sum for any partition.
template <class Unit, class Real, int planes>
class Extend_add {
  static constexpr Panel_layout layout = Simd_lanes<Unit, Real>::layout(planes);
  static constexpr int lanes = layout.lanes(), cell = layout.cell();

 public:
  using Child = Child_update<Real>;

  /// `Front_kernels::add_to_panel`
  static void add_to_panel(const Child& child, int columns, Real* panel, int begin, int end)
  {
    const int last_column = find(child, columns), last = find(child, end);
    Rows rows;
    for (rows.first = find(child, begin); rows.first < last; rows.first += Rows::most) {
      look_up(rows, last);
      for (int i = 0; i < rows.count; ++i)
        rows.target[i] = layout.panel_row(columns, child.place[rows.first + i]);
      for (int j = 0; j < internal::least(last_column, rows.first + rows.count); ++j)
        add_column(child, j, rows, panel + static_cast<std::int64_t>(child.place[j]) * cell);
    }
  }

  /// `Front_kernels::add_to_update`
  static void add_to_update(const Child& child, int columns, int rows_below, Real* update,
                            int begin, int end)
  {
    const int first_column = find(child, columns), blocks = layout.blocks(rows_below);
    const int last = find(child, columns + end);
    Rows rows;
    for (rows.first = find(child, columns + begin); rows.first < last; rows.first += Rows::most) {
      look_up(rows, last);
      for (int i = 0; i < rows.count; ++i)
        rows.target[i] = tile_row(child.place[rows.first + i] - columns);
      for (int j = first_column; j < rows.first + rows.count; ++j)
        add_column(child, j, rows, update + tile_column(blocks, child.place[j] - columns));
    }
  }

 private:
  // Some rows of the child, whose positions are looked up once for all columns.
  struct Rows {
    static constexpr int most = 256;
    int first, count;
    int source[most], target[most];
  };

  // Offset of a row within a block column of tiles, relative to row 0.
  static CGP_ALWAYS_INLINE int tile_row(int row)
  {
    return layout.block(row) * (lanes * cell) + layout.lane(row);
  }

  // Virtual position of row 0 of a column, as if its tiles above the diagonal were stored.
  static CGP_ALWAYS_INLINE std::int64_t tile_column(int blocks, int column)
  {
    const int b = layout.block(column);
    return layout.tile(blocks, b, b) - static_cast<std::int64_t>(b) * lanes * cell +
           layout.lane(column) * cell;
  }

  // Returns the first row of the child at or after that position of the front.
  static int find(const Child& child, int place)
  {
    int first = 0, count = child.rows;
    while (count > 0) {
      const int half = count / 2;
      const bool is_later = child.place[first + half] < place;
      first = is_later ? first + half + 1 : first;
      count = is_later ? count - half - 1 : half;
    }
    return first;
  }

  // Looks up the group of rows that begins at `rows.first`.
  static CGP_ALWAYS_INLINE void look_up(Rows& rows, int last)
  {
    rows.count = internal::least(Rows::most, last - rows.first);
    for (int i = 0; i < rows.count; ++i) rows.source[i] = tile_row(rows.first + i);
  }

  static void add_column(const Child& child, int column, const Rows& rows, Real* to)
  {
    const Real* const from = child.numbers + tile_column(layout.blocks(child.rows), column);
    for (int i = internal::greatest(0, column - rows.first); i < rows.count; ++i) {
      const Real* const f = from + rows.source[i];
      Real* const t = to + rows.target[i];
      CGP_UNROLL(4)
      for (int q = 0; q < planes; ++q) t[q * lanes] += f[q * lanes];
    }
  }
};

}  // namespace Conformal_geometry_processing::internal
