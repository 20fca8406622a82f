// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/vector_units/compiler_hints.h>

#include <cstdint>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief Memory layout of a front, for registers of any width.
///
/// A *panel* of k columns is stored by row blocks with as many rows as a register has lanes, each
/// [column][component][lane]: every access of the kernels is a whole register, at stride one, for
/// the factorization and for the solves. The k rows of the triangle fill row blocks of their own
/// before the rows below. The *update* for the parent is stored as the lower triangle of square
/// tiles, block column by block column, each tile [column][component][lane].
///
/// All functions are always inlined, because kernels for different vector units call them.
struct Panel_layout {
  int planes;     ///< real components of a scalar
  int log_lanes;  ///< binary logarithm of the number of lanes of a register

  CGP_ALWAYS_INLINE constexpr int lanes() const { return 1 << log_lanes; }

  /// Numbers per row block and column
  CGP_ALWAYS_INLINE constexpr int cell() const { return planes << log_lanes; }

  /// Numbers in a tile of an update
  CGP_ALWAYS_INLINE constexpr std::int64_t tile_size() const
  {
    return static_cast<std::int64_t>(cell()) << log_lanes;
  }

  /// Number of row blocks for this number of rows
  CGP_ALWAYS_INLINE constexpr int blocks(int rows) const
  {
    return (rows + lanes() - 1) >> log_lanes;
  }

  /// Row block of a row, or of a column's row in a triangle, and its lane
  CGP_ALWAYS_INLINE constexpr int block(int row) const { return row >> log_lanes; }
  CGP_ALWAYS_INLINE constexpr int lane(int row) const { return row & (lanes() - 1); }

  /// Numbers in a panel
  CGP_ALWAYS_INLINE constexpr std::int64_t panel_size(int columns, int rows_below) const
  {
    return static_cast<std::int64_t>(blocks(columns) + blocks(rows_below)) * columns * cell();
  }

  /// Position in the panel of the first component of a row of the front, in column 0
  CGP_ALWAYS_INLINE constexpr int panel_row(int columns, int row) const
  {
    const int below = row - columns;
    return row < columns ? block(row) * columns * cell() + lane(row)
                         : (blocks(columns) + block(below)) * columns * cell() + lane(below);
  }

  /// Likewise, in any column; the other components follow at distance `lanes()`
  CGP_ALWAYS_INLINE constexpr std::int64_t in_panel(int columns, int row, int column) const
  {
    return panel_row(columns, row) + static_cast<std::int64_t>(column) * cell();
  }

  /// Numbers in an update
  CGP_ALWAYS_INLINE constexpr std::int64_t update_size(int rows) const
  {
    const std::int64_t b = blocks(rows);
    return b * (b + 1) / 2 * tile_size();
  }

  /// Position of the tile of row block ib and column block jb <= ib, for nb row blocks
  CGP_ALWAYS_INLINE constexpr std::int64_t tile(int nb, int ib, int jb) const
  {
    const std::int64_t j = jb;
    return (j * nb - j * (j - 1) / 2 + ib - j) * tile_size();
  }

  /// Position of the first component of (row, column), row >= column, in an update of nb row blocks
  CGP_ALWAYS_INLINE constexpr std::int64_t in_update(int nb, int row, int column) const
  {
    return tile(nb, block(row), block(column)) + lane(column) * cell() + lane(row);
  }
};

}  // namespace Conformal_geometry_processing::internal
