// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/reduced/Reduced_form.h>

#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>

#include <cmath>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing {

internal::Ordering reduced_last(internal::Ordering order, const internal::Reduced_rows& rows)
{
  std::stable_partition(order.begin(), order.end(), [&](int i) { return !rows.is_reduced(i); });
  return order;
}

namespace internal {

// Operations of the real factor: those of the graph, scaled by the ratio of the front sizes with
// and without coordinates.
double operations_of_real_form(const Supernodal_structure& S, const Reduced_rows& rows)
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

internal::Reduced_form choose_reduced_form(const Sparse_pattern& pattern,
                                           const internal::Reduced_rows& rows,
                                           const internal::Ordering& order)
{
  const double of_quaternions = 0.52, of_complement = 0.57;
  const double m = 2. * rows.size_of_reduced();
  internal::Ordering last = reduced_last(order, rows);
  const double complement_cost =
      of_quaternions * 16 *
          internal::Elimination(pattern, last, rows.size_of_reduced()).operations() +
      of_complement * m * m * m / 3;
  const double real_cost =
      internal::operations_of_real_form(internal::Supernodal_structure(pattern, order), rows);
  if (real_cost < complement_cost) return {true, order, real_cost};
  return {false, std::move(last), complement_cost};
}

internal::Reduced_form choose_reduced_form(const Sparse_pattern& pattern,
                                           const internal::Reduced_rows& rows,
                                           const Eigen::Matrix3Xd* positions, int factorizations,
                                           const internal::Ordering_costs& costs)
{
  const internal::Ordering amd = amd_ordering(pattern);
  internal::Reduced_form by_degree = choose_reduced_form(pattern, rows, amd);
  const double seconds = by_degree.cost / 16 * costs.seconds_per_operation;
  if (positions == nullptr ||
      costs.expected_saving * factorizations * seconds <= costs.seconds_per_vertex * pattern.size())
    return by_degree;
  internal::Reduced_form by_dissection =
      choose_reduced_form(pattern, rows, sweep_nested_dissection(pattern, *positions, amd));
  return by_dissection.cost < by_degree.cost ? by_dissection : by_degree;
}

}  // namespace Conformal_geometry_processing
