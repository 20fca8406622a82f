// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/vector_units/Front_kernels.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/Simd_lanes.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/kernel_arithmetic.h>

#include <cstdint>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
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
