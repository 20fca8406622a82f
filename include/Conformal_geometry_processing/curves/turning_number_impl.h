// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_TURNING_NUMBER_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_TURNING_NUMBER_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/curves/turning_number.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE int turning_number(const Eigen::VectorXd& angles)
{
  return static_cast<int>(std::lround(angles.sum() / two_pi));
}

}  // namespace Conformal_geometry_processing

#endif
