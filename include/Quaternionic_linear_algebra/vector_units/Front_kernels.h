// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/vector_units/kernel_arithmetic.h>

#include <cstdint>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief The vector units for which the dense kernels of the factorizations are compiled,
/// narrowest first.
enum class Vector_unit {
  baseline,  ///< 16 bytes, available on every machine of the target: SSE2, NEON
  avx2,      ///< 32 bytes: AVX2 and FMA
  avx512     ///< 64 bytes: AVX-512 F, VL, DQ and BW
};

/// \name Vector units
/// Tag types of the vector units. All code that depends on the width of a register has one as a
/// template parameter, so that instances for different units have different names.
/// @{

/// 16 bytes
struct Baseline_unit {
  static constexpr Vector_unit unit = Vector_unit::baseline;
  static constexpr int bytes = 16;      ///< in a register
  static constexpr int registers = 16;  ///< available to a kernel
};

/// 32 bytes
struct Avx2_unit {
  static constexpr Vector_unit unit = Vector_unit::avx2;
  static constexpr int bytes = 32;
  static constexpr int registers = 16;
};

/// 64 bytes
struct Avx512_unit {
  static constexpr Vector_unit unit = Vector_unit::avx512;
  static constexpr int bytes = 64;
  static constexpr int registers = 32;
};

/// The widest unit for which this file is compiled: a wider kernel would spill to memory and be
/// several times slower than a narrow one
#if defined(__AVX512F__)
using Target_unit = Avx512_unit;
#elif defined(__AVX2__)
using Target_unit = Avx2_unit;
#else
using Target_unit = Baseline_unit;
#endif
/// @}

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

/// \brief The update that a child passes to the front of its parent.
template <class Real>
struct Child_update {
  const Real* numbers;
  int rows;          ///< number of rows of the child
  const int* place;  ///< their positions among the rows of the front, ascending
};

/// \brief A front with a factored panel, as input of the substitution.
///
/// The panel may be rounded, in each column to whole multiples of a unit.
template <class Real>
struct Factored_front {
  const Real* panel;  ///< null if it is rounded
  int columns, rows_below;
  const int* rows;                        ///< positions of the rows below in the vector
  const std::int16_t* rounded = nullptr;  ///< the panel without its diagonal, null if not rounded
  const Real* units = nullptr;            ///< of the columns of a rounded panel
  const Real* inverses = nullptr;         ///< of its diagonal
};

/// \brief Substitution kernels of one front, for several right-hand sides at once, whose numbers
/// are adjacent in every row of a vector.
template <class Real>
struct Front_substitution {
  /// \brief Adds the rows of a child to the rows y of the panel, and to those below
  void (*add_child)(const Child_update<Real>& child, int columns, Real* y, Real* below);

  /// \brief Computes y = L11^-1 y, then below -= L21 y
  void (*forward)(const Factored_front<Real>& front, Real* y, Real* below);

  /// \brief Computes y = L11^-H (y - L21^H x), with the rows of x that are below
  void (*backward)(const Factored_front<Real>& front, Real* y, const Real* x);
};

/// \brief Dense kernels for one front of a supernodal Cholesky factorization, compiled for one
/// vector unit and one kind of scalar, see `kernels_for()`.
///
/// A call processes a whole front or a large part of one, so that the indirect call costs nothing.
/// Data in the layout of one table can be processed by this table only. All arrays are aligned to
/// registers.
template <class Real>
struct Front_kernels {
  Vector_unit unit;
  Panel_layout layout;

  /// \brief Replaces the panel A = (A11; A21) by L11 with A11 = L11 L11^H and L21 = A21 L11^-H.
  /// \param row_blocks of the panel; if only those of the triangle, `solve_below` computes the rest
  /// \returns the first column whose pivot is not positive, -1 if all are
  int (*factor_panel)(Real* panel, int columns, int row_blocks);

  /// \brief Computes L21 in the row blocks begin <= block < end below a factored triangle.
  void (*solve_below)(Real* panel, int columns, int begin, int end);

  /// \brief Computes update = -L21 L21^H in the row blocks begin <= block < end of its lower
  /// triangle.
  /// \param below the row blocks of the panel under its triangle
  void (*set_outer_product)(Real* update, const Real* below, int columns, int rows, int begin,
                            int end);

  /// \brief Rounds what is below the diagonal of a factored panel to whole multiples of units, one
  /// for each column, as a factor of a matrix with a diagonal of about 1 allows: a column of less
  /// than 1e-30 becomes 0. The row after the diagonal makes up for the others, so that the sums of
  /// columns stay.
  /// \param panel is changed above the diagonal, which has no meaning there, and on it
  /// \param rounded receives the panel, without the row blocks above the diagonal
  /// \param units, inverses receive the units, and the inverses of the diagonal
  void (*round_panel)(Real* panel, int columns, int row_blocks, std::int16_t* rounded, Real* units,
                      Real* inverses);

  /// \brief Adds to the panel those columns of a child's update that are columns of the panel, in
  /// the rows begin <= row < end of the front.
  void (*add_to_panel)(const Child_update<Real>& child, int columns, Real* panel, int begin,
                       int end);

  /// \brief Adds to the update the other columns of the child's update, in the rows
  /// begin <= row < end below the panel.
  void (*add_to_update)(const Child_update<Real>& child, int columns, int rows_below, Real* update,
                        int begin, int end);

  Front_substitution<Real> single;  ///< with one number per row, for scalars of one
  Front_substitution<Real> narrow;  ///< with four numbers per row
  Front_substitution<Real> wide;    ///< with eight numbers per row
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// Maximal width of a panel in the substitution
constexpr int max_panel_width = 64;

}  // namespace Conformal_geometry_processing
