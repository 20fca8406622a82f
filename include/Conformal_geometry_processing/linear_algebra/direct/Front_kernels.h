// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_FRONT_KERNELS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_FRONT_KERNELS_H

#include <Conformal_geometry_processing/linear_algebra/direct/Scalar_planes.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Simd_lanes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the dense work on one front of a supernodal Cholesky factorization, for any scalar.
///
/// A *panel* of k columns is stored by row blocks of as many rows as a register has lanes, each
/// [column][component][lane]: every access of the kernels is a whole register, at stride one, for
/// the factorization and for the solves. The k rows of the triangle fill row blocks of their own
/// before the rows below. The *update* to be handed to the parent is stored as the lower triangle
/// of square tiles, block column by block column, each tile [column][component][lane].
///
/// All of it is one microkernel: registers of several columns minus a panel times the conjugate of
/// another. \tparam Scalar supplies the multiplication \tparam Real is stored
template <class Scalar, class Real>
class Front_kernels {
  using Planes = Scalar_planes<Scalar>;
  using Simd = Simd_lanes<Real>;
  using Register = typename Simd::Register;

 public:
  static constexpr int lanes = Simd::size;
  static constexpr int planes = Planes::size;
  static constexpr int cell = planes * lanes;  ///< numbers per row block and column
  static constexpr std::int64_t tile_size =
      std::int64_t(lanes) * cell;  ///< numbers of an update's tile

  static int blocks(int rows) { return (rows + lanes - 1) / lanes; }

  /// numbers in a panel
  static std::int64_t panel_size(int columns, int rows_below)
  {
    return static_cast<std::int64_t>(blocks(columns) + blocks(rows_below)) * columns * cell;
  }

  /// numbers in an update
  static std::int64_t update_size(int rows)
  {
    const std::int64_t b = blocks(rows);
    return b * (b + 1) / 2 * lanes * cell;
  }

  /// where the tile of row block ib and column block jb <= ib begins
  static std::int64_t tile(int nb, int ib, int jb)
  {
    return (static_cast<std::int64_t>(jb) * nb - static_cast<std::int64_t>(jb) * (jb - 1) / 2 + ib -
            jb) *
           tile_size;
  }

  /// \brief replaces the panel A = (A11; A21) by L11 with A11 = L11 L11^H and L21 = A21 L11^-H.
  /// \param row_blocks of the panel; with those of the triangle alone, `solve_below()` does the
  /// rest \returns the first column whose pivot is not positive, -1 if all are
  static int factor_panel(Real* panel, int columns, int row_blocks)
  {
    for (int j = 0; j < columns; j += group) {
      const int width = (std::min)(group, columns - j), diagonal = j / lanes, lane = j % lanes;
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

  /// \brief the same for the row blocks begin <= block < end below a triangle that is factored.
  static void solve_below(Real* panel, int columns, int begin, int end)
  {
    for (int j = 0; j < columns; j += group) {
      const int width = (std::min)(group, columns - j), diagonal = j / lanes;
      Triangle triangle;
      triangle.read(panel + place(columns, diagonal, j), j % lanes, width);
      solve_columns(panel, columns, j, triangle, begin, end);
    }
  }

  /// \brief update = -L21 L21^H in the row blocks begin <= block < end of its lower triangle.
  /// \param below the row blocks of the panel under its triangle
  static void set_outer_product(Real* update, const Real* below, int columns, int rows, int begin,
                                int end)
  {
    const int nb = blocks(rows);
    const std::int64_t stride = static_cast<std::int64_t>(columns) * cell;
    for (int jb = 0; jb < end; ++jb)
      for (int ib = (std::max)(jb, begin); ib < end; ++ib)
        for (int c = 0; c < (std::min)(lanes, rows - jb * lanes); c += group) {
          Register acc[group][planes] = {};
          subtract_products(acc, below + ib * stride, below + jb * stride + c, columns);
          store(update + tile(nb, ib, jb) + c * cell, group, acc);
        }
  }

 private:
  // Columns per kernel call: as many as keep the accumulators in registers, of which there are 32
  // with AVX-512 and 16 without.
  static constexpr int most = internal::simd_bytes == 64 ? 16 : 8;
  static constexpr int group = (std::min)(lanes, (std::max)(1, most / planes));
  static_assert(lanes % group == 0);

  class Triangle;

  static std::int64_t place(int columns, int block, int column)
  {
    return (static_cast<std::int64_t>(block) * columns + column) * cell;
  }

  // Subtracts what the columns before j contribute to the row block.
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract_earlier(Register (&acc)[group][planes],
                                                                    const Real* panel, int columns,
                                                                    int block, int j)
  {
    subtract_products(acc, panel + place(columns, block, 0),
                      panel + place(columns, j / lanes, 0) + j % lanes, j);
  }

  // Columns j, j + 1, ... of the row blocks begin <= block < end.
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void solve_columns(Real* panel, int columns, int j,
                                                                 const Triangle& triangle,
                                                                 int begin, int end)
  {
    const int width = (std::min)(group, columns - j);
    Register acc[group][planes];
    for (int block = begin; block < end; ++block) {
      Real* const cells = panel + place(columns, block, j);
      load(cells, width, acc);
      subtract_earlier(acc, panel, columns, block, j);
      triangle.solve(acc, width);
      store(cells, width, acc);
    }
  }

  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void load(const Real* from, int width,
                                                        Register (&acc)[group][planes])
  {
#pragma GCC unroll 16
    for (int c = 0; c < group; ++c)
#pragma GCC unroll 4
      for (int q = 0; q < planes; ++q)
        acc[c][q] = c < width ? Simd::load(from + c * cell + q * lanes) : Register{};
  }

  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void store(Real* to, int width,
                                                         const Register (&acc)[group][planes])
  {
    for (int c = 0; c < width; ++c)
#pragma GCC unroll 4
      for (int q = 0; q < planes; ++q) Simd::store(to + c * cell + q * lanes, acc[c][q]);
  }

  /// the microkernel: acc_c -= sum over the first `count` columns p of A_p conjugate(B_p,c), where
  /// B points to the lane of the first of the `group` rows of B
  static CONFORMAL_GEOMETRY_PROCESSING_INLINE void subtract_products(Register (&acc)[group][planes],
                                                                     const Real* A, const Real* B,
                                                                     int count)
  {
    for (int p = 0; p < count; ++p, A += cell, B += cell) {
      Register a[planes];
#pragma GCC unroll 4
      for (int q = 0; q < planes; ++q) a[q] = Simd::load(A + q * lanes);
#pragma GCC unroll 16
      for (int c = 0; c < group; ++c) {
        Real b[planes];
#pragma GCC unroll 4
        for (int q = 0; q < planes; ++q) b[q] = B[q * lanes + c];
        Planes::subtract_conjugated(acc[c], a, b);
      }
    }
  }

  /// the Cholesky factor of a diagonal block of at most `group` columns
  class Triangle {
   public:
    /// takes the block from the lanes of the accumulators; returns the first bad pivot, -1 if none
    int factor(const Register (&acc)[group][planes], int lane, int width)
    {
      for (int c = 0; c < width; ++c)
        for (int r = c; r < width; ++r)
          for (int q = 0; q < planes; ++q) m[r][c][q] = acc[c][q][lane + r];
      for (int c = 0; c < width; ++c) {
        for (int e = 0; e < c; ++e)
          for (int r = c; r < width; ++r) Planes::subtract_conjugated(m[r][c], m[r][e], m[c][e]);
        const Real pivot = m[c][c][0];
        if (!(pivot > 0) || !std::isfinite(pivot)) return c;
        const Real root = std::sqrt(pivot);
        m_inverse[c] = 1 / root;
        for (int q = 0; q < planes; ++q) m[c][c][q] = q == 0 ? root : Real(0);
        for (int r = c + 1; r < width; ++r)
          for (int q = 0; q < planes; ++q) m[r][c][q] *= m_inverse[c];
      }
      return -1;
    }

    /// takes the block from where `write()` has put it
    void read(const Real* from, int lane, int width)
    {
      for (int c = 0; c < width; ++c) {
        for (int r = c; r < width; ++r)
          for (int q = 0; q < planes; ++q) m[r][c][q] = from[c * cell + q * lanes + lane + r];
        m_inverse[c] = 1 / m[c][c][0];
      }
    }

    /// acc <- acc L^-H, for the rows below
    CONFORMAL_GEOMETRY_PROCESSING_INLINE void solve(Register (&acc)[group][planes], int width) const
    {
      for (int c = 0; c < width; ++c) {
        for (int d = 0; d < c; ++d) Planes::subtract_conjugated(acc[c], acc[d], m[c][d]);
        for (int q = 0; q < planes; ++q) acc[c][q] *= m_inverse[c];
      }
    }

    /// writes the block into its row block: exact, with zeros above the diagonal
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
};

}  // namespace Conformal_geometry_processing

#endif
