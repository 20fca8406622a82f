// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CLOSURE_RESIDUAL_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CLOSURE_RESIDUAL_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/closure_residual.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE double internal::closure_residual(const Surface_ref& surface,
                                             const Eigen::VectorXd& weights, const Points& f,
                                             const Eigen::MatrixX3d& edges)
{
  double difference = 0, total = 0;
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    const Eigen::Vector3d e = edges.row(k);
    const Eigen::Vector3d d = f.col(surface.ends(k)[1]) - f.col(surface.ends(k)[0]);
    difference += std::abs(weights[k]) * (d - e).squaredNorm();
    total += std::abs(weights[k]) * e.squaredNorm();
  }
  return std::sqrt(difference / total);
}

}  // namespace Conformal_geometry_processing

#endif
