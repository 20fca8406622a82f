// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/vector_units/Panel_layout.h>
#include <Conformal_geometry_processing/linear_algebra/vector_units/unit_tags.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// Maximal width of a panel in the substitution
constexpr int max_panel_width = 64;

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief The update that a child passes to the front of its parent.
template <class Real>
struct Child_update {
  const Real* numbers;
  int rows;          ///< number of rows of the child
  const int* place;  ///< their positions among the rows of the front, ascending
};

/// \ingroup PkgLinearAlgebra
/// \brief A front with a factored panel, as input of the substitution.
template <class Real>
struct Factored_front {
  const Real* panel;
  int columns, rows_below;
  const int* rows;  ///< positions of the rows below in the vector
};

/// \ingroup PkgLinearAlgebra
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

/// \ingroup PkgLinearAlgebra
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

}  // namespace Conformal_geometry_processing
