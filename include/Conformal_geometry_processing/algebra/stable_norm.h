// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_STABLE_NORM_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_STABLE_NORM_H

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// the length of a vector whose squares may overflow, or vanish. (Eigen's `stableNorm()` is for
/// vectors of any size, and takes longer to compile than most of what calls this.)
double stable_norm(const Eigen::Vector3d& v);

/// \ingroup PkgAlgebra
/// the unit vector of this direction, of however long a vector; zero for zero
Eigen::Vector3d stable_normalized(const Eigen::Vector3d& v);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/algebra/stable_norm_impl.h>
#endif

#endif
