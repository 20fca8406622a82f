// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_STABLE_NORM_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_STABLE_NORM_H

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

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/algebra/stable_norm_impl.h>
#endif

#endif
