// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_EXTEND_ADD_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_EXTEND_ADD_H

#include <Conformal_geometry_processing/linear_algebra/Front_kernels.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief adds the update that a child leaves to the front of its parent: some columns belong to
/// the panel of the parent, the others to its own update (see `Front_kernels` for their layouts).
///
/// Rows of the child become rows of the front by a list of places, so every number goes its own
/// way; the offsets that all columns share are computed once per child.
template <class Scalar, class Real>
class Extend_add {
  using Kernels = Front_kernels<Scalar, Real>;
  static constexpr int lanes = Kernels::lanes, cell = Kernels::cell, planes = Kernels::planes;

 public:
  /// \brief prepares for a front of so many columns and so many rows below.
  void set_front(int columns, int rows_below)
  {
    m_columns = columns;
    m_rows_below = rows_below;
    m_panel_row.resize(at(columns + rows_below));
    for (int i = 0; i < columns + rows_below; ++i) {
      const int block = i < columns ? i / lanes : Kernels::blocks(columns) + (i - columns) / lanes;
      m_panel_row[at(i)] = block * columns * cell + (i < columns ? i : i - columns) % lanes;
    }
    while (static_cast<int>(m_tile_row.size()) < rows_below) grow_tile_rows();
  }

  /// where the entry of the panel in that row of the front and that column is
  std::int64_t in_panel(int row, int column) const
  {
    return m_panel_row[at(row)] + static_cast<std::int64_t>(column) * cell;
  }

  /// \brief panel += the columns of a child's update that are columns of the panel.
  /// \param place the place in the front of each row of the child, ascending
  void add_to_panel(const Real* child, int child_rows, const int* place, Real* panel)
  {
    prepare(child_rows, [&](int i) { return m_panel_row[at(place[i])]; });
    for (int j = 0; j < child_rows && place[j] < m_columns; ++j)
      add_column(child, child_rows, j, panel + static_cast<std::int64_t>(place[j]) * cell);
  }

  /// \brief update += the other columns of the child's update.
  void add_to_update(const Real* child, int child_rows, const int* place, Real* update)
  {
    int begin = 0;
    while (begin < child_rows && place[begin] < m_columns) ++begin;
    prepare(child_rows,
            [&](int i) { return place[i] < m_columns ? 0 : m_tile_row[at(place[i] - m_columns)]; });
    for (int j = begin; j < child_rows; ++j)
      add_column(child, child_rows, j,
                 update + tile_column(Kernels::blocks(m_rows_below), place[j] - m_columns));
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  // Within a block column of tiles rows are this far from where row 0 would be.
  void grow_tile_rows()
  {
    const int i = static_cast<int>(m_tile_row.size());
    m_tile_row.push_back(i / lanes * (lanes * cell) + i % lanes);
  }

  // Where row 0 of a column would be, had its tiles above the diagonal been stored.
  static std::int64_t tile_column(int blocks, int column)
  {
    const int b = column / lanes;
    return Kernels::tile(blocks, b, b) - static_cast<std::int64_t>(b) * lanes * cell +
           column % lanes * cell;
  }

  template <class Offset>
  void prepare(int child_rows, Offset offset)
  {
    while (static_cast<int>(m_tile_row.size()) < child_rows) grow_tile_rows();
    m_target.resize(at(child_rows));
    for (int i = 0; i < child_rows; ++i) m_target[at(i)] = offset(i);
  }

  void add_column(const Real* child, int child_rows, int column, Real* to) const
  {
    const Real* const from = child + tile_column(Kernels::blocks(child_rows), column);
    const int* const source = m_tile_row.data();
    const int* const target = m_target.data();
    for (int i = column; i < child_rows; ++i) {
      const Real* const f = from + source[i];
      Real* const t = to + target[i];
#pragma GCC unroll 4
      for (int q = 0; q < planes; ++q) t[q * lanes] += f[q * lanes];
    }
  }

  int m_columns = 0, m_rows_below = 0;
  std::vector<int> m_panel_row, m_tile_row, m_target;
};

}  // namespace Conformal_geometry_processing

#endif
