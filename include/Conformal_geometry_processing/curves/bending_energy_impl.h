// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_CURVES_BENDING_ENERGY_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_CURVES_BENDING_ENERGY_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/curves/bending_energy.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE double bending_energy(const Eigen::VectorXd& curvatures,
                                 const internal::Polygon_lengths& lengths)
{
  return (curvatures.array().square() * lengths.duals().array()).sum();
}

}  // namespace Conformal_geometry_processing

#endif
