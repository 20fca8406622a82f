// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_ORDERING_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_ORDERING_H

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief an order of elimination: entry k is the number of the row that is eliminated as k-th.
///
/// Orders the n rows of a `Sparse_pattern`, whatever the scalar of the matrix is, so that the real
/// and the quaternionic matrix of a mesh share one.
using Ordering = std::vector<int>;

/// \relates Ordering
/// the permutation from old to new numbers; empty if `order` is not a permutation of 0 ... n - 1
inline std::vector<int> inverse_permutation(const Ordering& order)
{
  std::vector<int> inverse(order.size(), -1);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto old = static_cast<std::size_t>(order[k]);
    if (order[k] < 0 || old >= order.size() || inverse[old] >= 0) return {};
    inverse[old] = static_cast<int>(k);
  }
  return inverse;
}

}  // namespace Conformal_geometry_processing

#endif
