// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_PROLONGATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_PROLONGATION_H

#include <Conformal_geometry_processing/linear_algebra/multigrid/aggregate.h>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief a sparse real matrix P, row by row, that carries vectors from a coarse level to a fine
/// one; its transpose carries residuals back.
struct Prolongation {
  std::vector<int> offsets;    ///< number of fine vertices + 1
  std::vector<int> columns;    ///< coarse vertices
  std::vector<float> weights;  ///< beside `columns`
  int coarse_size = 0;

  int fine_size() const { return static_cast<int>(offsets.size()) - 1; }
  std::size_t bytes() const
  {
    return sizeof(int) * (offsets.size() + columns.size()) + sizeof(float) * weights.size();
  }

  /// calls visit(I, P_iI) for the entries of row i
  template <class Visitor>
  void for_each_in_row(int i, Visitor visit) const
  {
    const std::size_t begin = static_cast<std::size_t>(offsets[static_cast<std::size_t>(i)]);
    const std::size_t end = static_cast<std::size_t>(offsets[static_cast<std::size_t>(i) + 1]);
    for (std::size_t k = begin; k < end; ++k) visit(columns[k], weights[k]);
  }
};

/// \relates Prolongation
/// \brief piecewise constant on the aggregates, then smoothed by one step of weighted Jacobi along
/// the connections: row i is (1 - omega) e(i) + omega sum_j w_ij e(j) / sum_j w_ij, with e(j) the
/// unit vector of the aggregate of j.
///
/// Rows have no negative entries and sum to one, so constants are carried over exactly; rows of
/// vertices without connections are empty, for smoothing alone solves those.
inline Prolongation smoothed_prolongation(const Connection_graph& graph, const Aggregation& a,
                                          double omega)
{
  Prolongation P;
  P.coarse_size = a.size;
  P.offsets.reserve(static_cast<std::size_t>(graph.size()) + 1);
  P.offsets.push_back(0);
  std::vector<int> place(static_cast<std::size_t>(a.size), -1);  // of a column in the last row
  for (int i = 0; i < graph.size(); ++i) {
    const int row = P.offsets.back();
    const auto add = [&](int vertex, double weight) {
      const int c = a.aggregate_of[static_cast<std::size_t>(vertex)];
      int& k = place[static_cast<std::size_t>(c)];
      if (k < row) {
        k = static_cast<int>(P.columns.size());
        P.columns.push_back(c);
        P.weights.push_back(0);
      }
      P.weights[static_cast<std::size_t>(k)] += static_cast<float>(weight);
    };
    double sum = 0;
    for (int k = graph.begin(i); k < graph.end(i); ++k) sum += static_cast<double>(graph.weight(k));
    if (sum > 0) add(i, 1 - omega);
    for (int k = graph.begin(i); k < graph.end(i); ++k)
      add(graph.neighbor(k), omega * static_cast<double>(graph.weight(k)) / sum);
    P.offsets.push_back(static_cast<int>(P.columns.size()));
  }
  return P;
}

}  // namespace Conformal_geometry_processing

#endif
