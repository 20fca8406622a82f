// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

std::vector<int> inverse_permutation(const internal::Ordering& order)
{
  std::vector<int> inverse(order.size(), -1);
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto old = static_cast<std::size_t>(order[k]);
    if (order[k] < 0 || old >= order.size() || inverse[old] >= 0) return {};
    inverse[old] = static_cast<int>(k);
  }
  return inverse;
}

internal::Ordering amd_ordering(const Sparse_pattern& pattern)
{
  using Graph = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;
  const std::vector<double> ones(pattern.indices.size(), 1.0);
  const Eigen::Map<const Graph> lower(pattern.size(), pattern.size(), pattern.size_of_entries(),
                                      pattern.offsets.data(), pattern.indices.data(), ones.data());
  const Graph graph = lower.selfadjointView<Eigen::Lower>();
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(graph, permutation);
  return internal::Ordering(permutation.indices().data(),
                            permutation.indices().data() + pattern.size());
}

}  // namespace Conformal_geometry_processing
