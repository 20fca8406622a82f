// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgCurves
/// \brief Returns the bending energy, the integral of the squared curvature, sum kappa^2 d
/// [CGP 6.4.3].
///
/// In 1/length; its product with the length of the curve is scale-invariant, and 4 pi^2 k^2 for a
/// k-fold circle.
/// \param curvatures the turning angles divided by the dual lengths, one per vertex
double bending_energy(const Eigen::VectorXd& curvatures, const internal::Polygon_lengths& lengths);

}  // namespace Conformal_geometry_processing
