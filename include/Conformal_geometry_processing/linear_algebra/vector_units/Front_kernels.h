// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_FRONT_KERNELS_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_VECTOR_UNITS_FRONT_KERNELS_H

#include <Conformal_geometry_processing/linear_algebra/vector_units/Panel_layout.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/unit_tags.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// the widest panel that the substitution serves
constexpr int max_panel_width = 64;

/// \ingroup PkgLinearAlgebra
/// \brief what a child hands to the front of its parent.
template <class Real>
struct Child_update {
  const Real* numbers;
  int rows;          ///< of the child
  const int* place;  ///< where each of them is among the rows of the front, ascending
};

/// \ingroup PkgLinearAlgebra
/// \brief a front whose panel is factored, as the substitution sees it.
template <class Real>
struct Factored_front {
  const Real* panel;
  int columns, rows_below;
  const int* rows;  ///< where the rows below are in the vector
};

/// \ingroup PkgLinearAlgebra
/// \brief the substitution of one front, for some right-hand sides at once, whose numbers are side
/// by side in every row of a vector.
template <class Real>
struct Front_substitution {
  /// \brief adds the rows of a child to the rows y of the panel, and to those below
  void (*add_child)(const Child_update<Real>& child, int columns, Real* y, Real* below);

  /// \brief y becomes L11^-1 y, and below -= L21 y
  void (*forward)(const Factored_front<Real>& front, Real* y, Real* below);

  /// \brief y becomes L11^-H (y - L21^H x), with the rows of x that are below
  void (*backward)(const Factored_front<Real>& front, Real* y, const Real* x);
};

/// \ingroup PkgLinearAlgebra
/// \brief the dense work on one front of a supernodal Cholesky factorization: functions that are
/// compiled for one vector unit and one kind of scalar, see `kernels_for()`.
///
/// A call does a whole front or a large part of one, so that it costs nothing to choose among
/// tables when the program runs. Numbers laid out by a table belong to that table. All
/// arrays are aligned to registers.
template <class Real>
struct Front_kernels {
  Vector_unit unit;
  Panel_layout layout;

  /// \brief replaces the panel A = (A11; A21) by L11 with A11 = L11 L11^H and L21 = A21 L11^-H.
  /// \param row_blocks of the panel; with those of the triangle alone, `solve_below` does the rest
  /// \returns the first column whose pivot is not positive, -1 if all are
  int (*factor_panel)(Real* panel, int columns, int row_blocks);

  /// \brief the same for the row blocks begin <= block < end below a triangle that is factored.
  void (*solve_below)(Real* panel, int columns, int begin, int end);

  /// \brief update = -L21 L21^H in the row blocks begin <= block < end of its lower triangle.
  /// \param below the row blocks of the panel under its triangle
  void (*set_outer_product)(Real* update, const Real* below, int columns, int rows, int begin,
                            int end);

  /// \brief panel += the columns of a child's update that are columns of the panel, in the rows
  /// begin <= row < end of the front.
  void (*add_to_panel)(const Child_update<Real>& child, int columns, Real* panel, int begin,
                       int end);

  /// \brief update += the other columns of the child's update, in the rows begin <= row < end below
  /// the panel.
  void (*add_to_update)(const Child_update<Real>& child, int columns, int rows_below, Real* update,
                        int begin, int end);

  Front_substitution<Real> narrow;  ///< with four numbers per row
  Front_substitution<Real> wide;    ///< with eight numbers per row
};

}  // namespace Conformal_geometry_processing

#endif
