// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// Returns the length of a vector without overflow or underflow. (Eigen's `stableNorm()` is for
/// vectors of any size, and takes longer to compile than most callers of this function.)
double stable_norm(const Eigen::Vector3d& v);

/// \ingroup PkgAlgebra
/// Returns the unit vector in the direction of a vector of any length; zero for zero
Eigen::Vector3d stable_normalized(const Eigen::Vector3d& v);

}  // namespace Conformal_geometry_processing
