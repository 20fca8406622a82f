// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/curves/turning_number.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

int turning_number(const Eigen::VectorXd& angles)
{
  return static_cast<int>(std::lround(angles.sum() / two_pi));
}

}  // namespace Conformal_geometry_processing
