// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_PIVOT_TRIANGLE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_PIVOT_TRIANGLE_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/Plane_products.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/Simd_lanes.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/plain_functions.h>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
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
      if (!internal::is_positive_and_finite(pivot)) return c;
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

}  // namespace internal

}  // namespace Conformal_geometry_processing

#endif
