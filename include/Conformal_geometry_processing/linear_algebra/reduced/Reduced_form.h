// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_REDUCED_REDUCED_FORM_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_REDUCED_REDUCED_FORM_H

#include <Conformal_geometry_processing/algebra/Reduced_rows.h>
#include <Conformal_geometry_processing/linear_algebra/direct/choose_ordering.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief how a reduced system is factored: all of it as a real matrix, or the unreduced rows as
/// quaternions and then the Schur complement of the others as a real matrix; and in which order.
struct Reduced_form {
  bool is_real = false;
  Ordering order;   ///< of all rows; with the reduced ones last where they are to be
  double cost = 0;  ///< floating point operations, those that run slower counted more
};

/// \ingroup PkgLinearAlgebra
/// \brief the ordering with the reduced rows moved to its end.
inline Ordering reduced_last(Ordering order, const Reduced_rows& rows)
{
  std::stable_partition(order.begin(), order.end(), [&](int i) { return !rows.is_reduced(i); });
  return order;
}

namespace internal {

// Of the real factor: those of the graph, in the ratio of the fronts with and without coordinates.
inline double operations_of_real_form(const Supernodal_structure& S, const Reduced_rows& rows)
{
  const auto dimension = [&](int k) {
    return rows.dimension(S.order()[static_cast<std::size_t>(k)]);
  };
  const auto front = [](double columns, double below) {
    return (std::pow(columns + below, 3) - std::pow(below, 3)) / 3;
  };
  double of_coordinates = 0, of_rows = 0;
  for (int s = 0; s < S.size(); ++s) {
    double below = 0, columns = 0;
    for (int i = 0; i < S.height(s); ++i) below += dimension(S.rows(s)[i]);
    for (int j = 0; j < S.width(s); ++j) columns += dimension(S.first(s) + j);
    of_coordinates += front(columns, below);
    of_rows += front(S.width(s), S.height(s));
  }
  return S.operations() * of_coordinates / of_rows;
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief the cheaper form for an ordering; the same on every machine.
///
/// A quaternionic product does four operations for every number it loads, and so takes about half
/// the time of as many real ones; the dense complement is nearly as fast. Measured by
/// benchmark/reduced_solver.cpp, one thread, AVX-512, processor time of the numeric factorization
/// in units of the quaternionic one of the same X with nothing reduced:
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
/// A solution takes 1.2 to 2.2 times that without reduced rows by the complement, where that is the
/// choice, and 3 to 4.5 times by the real form; memory is half of that of the real form on disks.
inline Reduced_form choose_reduced_form(const Sparse_pattern& pattern, const Reduced_rows& rows,
                                        const Ordering& order)
{
  const double of_quaternions = 0.52, of_complement = 0.57;
  const double m = 2. * rows.size_of_reduced();
  Ordering last = reduced_last(order, rows);
  const double complement_cost =
      of_quaternions * 16 *
          Supernodal_structure(pattern, last, rows.size_of_reduced()).operations() +
      of_complement * m * m * m / 3;
  const double real_cost =
      internal::operations_of_real_form(Supernodal_structure(pattern, order), rows);
  if (real_cost < complement_cost) return {true, order, real_cost};
  return {false, std::move(last), complement_cost};
}

/// \ingroup PkgLinearAlgebra
/// \brief the cheaper form, for an ordering chosen as `choose_structure()` does.
/// \param positions 3 x n, or null
inline Reduced_form choose_reduced_form(const Sparse_pattern& pattern, const Reduced_rows& rows,
                                        const Eigen::Matrix3Xd* positions, int factorizations,
                                        const Ordering_costs& costs = {})
{
  Reduced_form by_degree = choose_reduced_form(pattern, rows, amd_ordering(pattern));
  const double seconds = by_degree.cost / 16 * costs.seconds_per_operation;
  if (positions == nullptr ||
      costs.expected_saving * factorizations * seconds <= costs.seconds_per_vertex * pattern.size())
    return by_degree;
  Reduced_form by_dissection =
      choose_reduced_form(pattern, rows, sweep_nested_dissection(pattern, *positions));
  return by_dissection.cost < by_degree.cost ? by_dissection : by_degree;
}

}  // namespace Conformal_geometry_processing

#endif
