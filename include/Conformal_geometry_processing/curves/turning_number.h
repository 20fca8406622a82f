// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// A full turn
inline constexpr double two_pi = 6.283185307179586476925286766559;

/// \ingroup PkgCurves
/// \brief Returns the turning number of a closed polygon, counterclockwise: 1 for a convex one, 0
/// for a figure eight [CGP 4.2].
/// \param angles of `turning_angles()`
int turning_number(const Eigen::VectorXd& angles);

}  // namespace Conformal_geometry_processing
