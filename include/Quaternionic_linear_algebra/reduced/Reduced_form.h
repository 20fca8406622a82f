// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>
#include <Quaternionic_linear_algebra/direct/choose_ordering.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Strategy for the factorization of a reduced system, and its ordering: either the whole
/// system as a real matrix, or the unreduced rows as quaternions and the Schur complement of the
/// others as a real matrix.
struct Reduced_form {
  bool is_real = false;
  Ordering order;   ///< of all rows; the reduced ones are last if the form requires it
  double cost = 0;  ///< floating-point operations, weighted by their speed
};

double operations_of_real_form(const Supernodal_structure& S, const Reduced_rows& rows);

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Moves the reduced rows to the end of the ordering.
internal::Ordering reduced_last(internal::Ordering order, const internal::Reduced_rows& rows);

/// \ingroup PkgLinearAlgebra
/// \brief Chooses the cheaper form for an ordering; independent of the machine.
///
/// A quaternionic product performs four operations per loaded number, and therefore takes about
/// half the time of as many real ones; the dense complement is nearly as fast. Measured by
/// benchmark/reduced_solver.cpp, one thread, AVX-512, processor time of the numeric factorization
/// in units of the quaternionic one of the same X without reduction:
///
/// | mesh                    | reduced / all  | real form | complement | CHOLMOD, real form |
/// |-------------------------|----------------|-----------|------------|--------------------|
/// | disk of 20 rings        |   120 /  1 261 |       5.0 |        2.4 |                 23 |
/// | disk of 40 rings        |   240 /  4 921 |       4.9 |        2.3 |                 16 |
/// | disk of 80 rings        |   480 / 19 441 |       5.2 |        2.5 |                 13 |
/// | disk of 160 rings       |   960 / 77 281 |       6.1 |        2.8 |                 14 |
/// | square                  |   480 / 14 641 |       6.2 |        3.5 |                 18 |
/// | cylinder, 6 x 2 pi      |   240 / 14 520 |       7.6 |        2.1 |                 17 |
/// | annulus, radii 1 and 2  |   720 / 21 960 |       4.9 |        4.2 |                 13 |
/// | annulus, radii 1.5, 2   | 1 440 / 43 920 |       4.9 |        7.8 |                 14 |
/// | strip of 400 x 16       |   832 /  6 817 |       5.3 |         27 |                 24 |
///
/// A solution takes 1.2 to 2.2 times as long as without reduced rows if the complement is chosen,
/// and 3 to 4.5 times as long with the real form; the complement takes half the memory of the real
/// form on disks.
internal::Reduced_form choose_reduced_form(const Sparse_pattern& pattern,
                                           const internal::Reduced_rows& rows,
                                           const internal::Ordering& order);

/// \ingroup PkgLinearAlgebra
/// \brief Chooses the cheaper form, with an ordering as in `choose_structure()`.
/// \param positions 3 x n, or null
internal::Reduced_form choose_reduced_form(const Sparse_pattern& pattern,
                                           const internal::Reduced_rows& rows,
                                           const Eigen::Matrix3Xd* positions, int factorizations,
                                           const internal::Ordering_costs& costs = {});

}  // namespace Conformal_geometry_processing
