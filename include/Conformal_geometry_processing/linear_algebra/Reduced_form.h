// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_REDUCED_FORM_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_REDUCED_FORM_H

#include <Conformal_geometry_processing/algebra/Reduced_rows.h>
#include <Conformal_geometry_processing/linear_algebra/choose_ordering.h>

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
/// Fronts of quaternions do four operations for every number they load, and run 1.8 times as fast
/// as real ones; the dense complement lies between. Measured (one thread, AVX-512, seconds relative
/// to the quaternionic factor of the same graph with nothing reduced; disk of n rings):
///
/// | mesh                 | reduced / all | real form | complement | CHOLMOD, real form |
/// |----------------------|---------------|-----------|------------|--------------------|
/// | disk, n = 20         |  120 /  1 261 |       4.5 |        2.2 |                 21 |
/// | disk, n = 40         |  240 /  4 921 |       5.0 |        2.4 |                 17 |
/// | disk, n = 80         |  480 / 19 441 |       5.0 |        2.5 |                 14 |
/// | disk, n = 160        |  960 / 77 281 |       6.2 |        2.9 |                 12 |
/// | square               |  480 / 14 641 |       6.3 |        3.4 |                 18 |
/// | annulus, radii 1, 2  |  720 / 21 960 |       5.2 |        4.3 |                 14 |
/// | cylinder, 6 x 2 pi   |  240 / 14 520 |       7.7 |        2.1 |                 18 |
///
/// A strip that is a few triangles wide is the case for the real form.
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
