// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spin_transformation_options.h>

#include <Eigen/Core>

#include <limits>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// options of `Conformal_deformation`
struct Conformal_deformation_options {
  /// how handles stay closed, mollification, and the bound on scales; the boundary has to be free
  Spin_transformation_options surface = {};
  /// weight of the distances from the targets against rho, in multiples of 1 / R with R the radius
  /// of the sphere of the same area; infinity: the targets are met exactly
  double position_weight = std::numeric_limits<double>::infinity();
  /// for each vertex of the mesh its weight in the `Region_of_interest`; empty: all may move
  Eigen::VectorXd region = {};
  double min_step = 1. / 32;  ///< the smallest step towards the targets, as a share of the way
};

}  // namespace Conformal_geometry_processing::internal
