// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_EXTEND_ADD_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_EXTEND_ADD_H

#include <Conformal_geometry_processing/linear_algebra/direct/Front_kernels.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief adds the update that a child leaves to the front of its parent: some columns belong to
/// the panel of the parent, the others to its own update (see `Front_kernels` for their layouts).
///
/// Rows of the child become rows of the front by a list of places, so every number goes its own
/// way. Only the rows of the front between two bounds are served, so that parts of a front can be
/// added to at the same time: each number is the same sum whatever the parts.
template <class Scalar, class Real>
class Extend_add {
  using Kernels = Front_kernels<Scalar, Real>;
  static constexpr int lanes = Kernels::lanes, cell = Kernels::cell, planes = Kernels::planes;

 public:
  /// the update of a child: its rows, and the place of each in the front, ascending
  struct Child {
    const Real* update;
    int rows;
    const int* place;
  };

  /// \param columns of the panel \param rows_below the rows of the front that follow
  Extend_add(int columns, int rows_below) : m_columns(columns), m_rows_below(rows_below) {}

  /// where the entry of the panel in that row of the front and that column is
  std::int64_t in_panel(int row, int column) const
  {
    return panel_row(row) + static_cast<std::int64_t>(column) * cell;
  }

  /// \brief panel += the columns of a child's update that are columns of the panel, in the rows
  /// begin <= row < end of the front.
  void add_to_panel(const Child& child, Real* panel, int begin, int end) const
  {
    const int last_column = find(child, m_columns);
    for_row_groups(child, begin, end, [&](Rows& rows) {
      for (int i = 0; i < rows.count; ++i) rows.target[i] = panel_row(child.place[rows.first + i]);
      for (int j = 0; j < (std::min)(last_column, rows.first + rows.count); ++j)
        add_column(child, j, rows, panel + static_cast<std::int64_t>(child.place[j]) * cell);
    });
  }

  /// \brief update += the other columns of the child's update, in the rows begin <= row < end below
  /// the panel.
  void add_to_update(const Child& child, Real* update, int begin, int end) const
  {
    const int first_column = find(child, m_columns), blocks = Kernels::blocks(m_rows_below);
    for_row_groups(child, m_columns + begin, m_columns + end, [&](Rows& rows) {
      for (int i = 0; i < rows.count; ++i)
        rows.target[i] = tile_row(child.place[rows.first + i] - m_columns);
      for (int j = first_column; j < rows.first + rows.count; ++j)
        add_column(child, j, rows, update + tile_column(blocks, child.place[j] - m_columns));
    });
  }

 private:
  // Some rows of the child, whose places are looked up at once for all columns.
  struct Rows {
    static constexpr int most = 256;
    int first, count;
    int source[most], target[most];
  };

  int panel_row(int row) const
  {
    const int block =
        row < m_columns ? row / lanes : Kernels::blocks(m_columns) + (row - m_columns) / lanes;
    const int lane = (row < m_columns ? row : row - m_columns) % lanes;
    return block * m_columns * cell + lane;
  }

  // Within a block column of tiles rows are this far from where row 0 would be.
  static int tile_row(int row) { return row / lanes * (lanes * cell) + row % lanes; }

  // Where row 0 of a column would be, had its tiles above the diagonal been stored.
  static std::int64_t tile_column(int blocks, int column)
  {
    const int b = column / lanes;
    return Kernels::tile(blocks, b, b) - static_cast<std::int64_t>(b) * lanes * cell +
           column % lanes * cell;
  }

  // The first row of the child at that place of the front or after it.
  static int find(const Child& child, int place)
  {
    return static_cast<int>(std::lower_bound(child.place, child.place + child.rows, place) -
                            child.place);
  }

  template <class Visitor>
  static void for_row_groups(const Child& child, int begin, int end, Visitor visit)
  {
    const int last = find(child, end);
    Rows rows;
    for (int first = find(child, begin); first < last; first += Rows::most) {
      rows.first = first;
      rows.count = (std::min)(Rows::most, last - first);
      for (int i = 0; i < rows.count; ++i) rows.source[i] = tile_row(first + i);
      visit(rows);
    }
  }

  static void add_column(const Child& child, int column, const Rows& rows, Real* to)
  {
    const Real* const from = child.update + tile_column(Kernels::blocks(child.rows), column);
    for (int i = (std::max)(0, column - rows.first); i < rows.count; ++i) {
      const Real* const f = from + rows.source[i];
      Real* const t = to + rows.target[i];
#pragma GCC unroll 4
      for (std::ptrdiff_t q = 0; q < planes; ++q) t[q * lanes] += f[q * lanes];
    }
  }

  int m_columns, m_rows_below;
};

}  // namespace Conformal_geometry_processing

#endif
