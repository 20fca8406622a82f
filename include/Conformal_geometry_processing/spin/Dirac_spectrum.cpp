// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace Conformal_geometry_processing {

bool internal::Dirac_spectrum::is_complete() const
{
  if (!converged || size() < wanted) return false;
  return ((eigenvalues.array() - shift).abs() <= complete_radius).all();
}

std::vector<internal::Multiple_eigenvalue> with_multiplicities(const Eigen::VectorXd& eigenvalues,
                                                               double resolution)
{
  Eigen::VectorXd sorted = eigenvalues;
  std::sort(sorted.begin(), sorted.end());
  std::vector<internal::Multiple_eigenvalue> groups;
  for (Eigen::Index i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i] - sorted[i - 1] >= resolution) groups.push_back({0, 0});
    internal::Multiple_eigenvalue& group = groups.back();
    group.value += (sorted[i] - group.value) / ++group.multiplicity;
  }
  return groups;
}

}  // namespace Conformal_geometry_processing
