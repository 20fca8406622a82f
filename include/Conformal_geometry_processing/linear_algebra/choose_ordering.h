// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_CHOOSE_ORDERING_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_CHOOSE_ORDERING_H

#include <Conformal_geometry_processing/linear_algebra/Supernodal_structure.h>
#include <Conformal_geometry_processing/linear_algebra/amd_ordering.h>
#include <Conformal_geometry_processing/linear_algebra/sweep_nested_dissection.h>

#include <Eigen/Core>

#include <memory>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief what the choice of an ordering reckons with. Only ratios of the times matter, which
/// differ little among machines.
struct Ordering_costs {
  /// of one operation of `Supernodal_structure::operations()` on quaternions: 16 multiplications
  /// and additions at 40 Gflop/s
  double seconds_per_operation = 16 / 40e9;

  /// of `sweep_nested_dissection()` and the analysis of what it finds
  double seconds_per_vertex = 1.4e-6;

  /// the share of the operations that dissection saves on meshes where minimum degree does badly
  double expected_saving = 0.45;
};

/// \ingroup PkgLinearAlgebra
/// \brief the structure of the factor for an ordering chosen automatically.
///
/// Minimum degree comes first: it takes a quarter of the time of anything else, its analysis tells
/// exactly how many operations a factorization will take, and on small or convoluted meshes it is
/// as good as dissection. Only where the operations that dissection is expected to save take longer
/// than dissection itself, it is tried too, and the structure with fewer operations is kept: one
/// can never do worse than minimum degree, but for the time of the trial.
/// \param positions 3 x n, or null: without positions the answer is minimum degree
/// \param factorizations how many are expected to follow, each of the costs given
inline std::shared_ptr<const Supernodal_structure> choose_structure(
    const Sparse_pattern& pattern, const Eigen::Matrix3Xd* positions, int factorizations = 1,
    const Ordering_costs& costs = {})
{
  auto by_degree = std::make_shared<const Supernodal_structure>(pattern, amd_ordering(pattern));
  const double saving = costs.expected_saving * factorizations * by_degree->operations() *
                        costs.seconds_per_operation;
  if (positions == nullptr || saving <= costs.seconds_per_vertex * pattern.size()) return by_degree;
  auto by_dissection = std::make_shared<const Supernodal_structure>(
      pattern, sweep_nested_dissection(pattern, *positions));
  return by_dissection->operations() < by_degree->operations() ? by_dissection : by_degree;
}

/// \ingroup PkgLinearAlgebra
/// \brief the ordering of `choose_structure()`.
inline Ordering choose_ordering(const Sparse_pattern& pattern, const Eigen::Matrix3Xd* positions,
                                int factorizations = 1, const Ordering_costs& costs = {})
{
  return choose_structure(pattern, positions, factorizations, costs)->order();
}

}  // namespace Conformal_geometry_processing

#endif
