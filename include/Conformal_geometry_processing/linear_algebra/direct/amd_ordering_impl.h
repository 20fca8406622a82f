// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_AMD_ORDERING_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_AMD_ORDERING_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/direct/amd_ordering.h>

#include <Eigen/Core>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include <vector>

namespace Conformal_geometry_processing {

CGP_INLINE internal::Ordering amd_ordering(const Sparse_pattern& pattern)
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

#endif
