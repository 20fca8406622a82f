// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/multigrid/aggregate.h>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief A sparse real matrix P, row by row, that interpolates vectors from a coarse to a fine
/// level; its transpose restricts residuals.
struct Prolongation {
  std::vector<int> offsets;    ///< number of fine vertices + 1
  std::vector<int> columns;    ///< coarse vertices
  std::vector<float> weights;  ///< parallel to `columns`
  int coarse_size = 0;

  int fine_size() const { return static_cast<int>(offsets.size()) - 1; }
  std::size_t bytes() const;

  /// Calls visit(I, P_iI) for the entries of row i
  template <class Visitor>
  void for_each_in_row(int i, Visitor visit) const
  {
    const std::size_t begin = static_cast<std::size_t>(offsets[static_cast<std::size_t>(i)]);
    const std::size_t end = static_cast<std::size_t>(offsets[static_cast<std::size_t>(i) + 1]);
    for (std::size_t k = begin; k < end; ++k) visit(columns[k], weights[k]);
  }
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes a prolongation that is piecewise constant on the aggregates, smoothed by one
/// step of weighted Jacobi along the connections: row i is
/// (1 - omega) e(i) + omega sum_j w_ij e(j) / sum_j w_ij, with e(j) the unit vector of the
/// aggregate of j.
///
/// Rows have no negative entries and sum to one, so constants are reproduced exactly; rows of
/// vertices without connections are empty, because smoothing solves for these.
internal::Prolongation smoothed_prolongation(const internal::Connection_graph& graph,
                                             const internal::Aggregation& a, double omega);

}  // namespace Conformal_geometry_processing
