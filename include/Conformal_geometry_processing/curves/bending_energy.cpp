// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/bending_energy.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

double bending_energy(const Eigen::VectorXd& curvatures, const internal::Polygon_lengths& lengths)
{
  return (curvatures.array().square() * lengths.duals().array()).sum();
}

}  // namespace Conformal_geometry_processing
