// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRUM_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRUM_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace Conformal_geometry_processing {

CGP_INLINE bool internal::Dirac_spectrum::is_complete() const
{
  if (!converged || size() < wanted) return false;
  return ((eigenvalues.array() - shift).abs() <= complete_radius).all();
}

CGP_INLINE std::vector<internal::Multiple_eigenvalue> with_multiplicities(
    const Eigen::VectorXd& eigenvalues, double resolution)
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

#endif
