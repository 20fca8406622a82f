// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief the direction -H of the conformal Willmore flow [CGP 6.4.2]: the flow changes the
/// curvature itself, so every frequency is damped at the same rate.
///
/// H is computed with mixed Voronoi areas: icospheres are then fixed points to 1e-7, with
/// barycentric areas only to 1e-4.
struct Willmore_direction {
  /// the prescribed rate of change of H |df|, |V| numbers in 1/length
  Eigen::VectorXd operator()(const Surface_ref& surface) const { return -mean_curvature(surface); }

  /// the energy that the flow decreases
  double energy(const Surface_ref& surface) const { return willmore_energy(surface); }
};

}  // namespace Conformal_geometry_processing
