// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_STABLE_NORM_H
#define CONFORMAL_GEOMETRY_PROCESSING_ALGEBRA_STABLE_NORM_H

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgAlgebra
/// the length of a vector whose squares may overflow, or vanish. (Eigen's `stableNorm()` is for
/// vectors of any size, and takes longer to compile than most of what calls this.)
inline double stable_norm(const Eigen::Vector3d& v)
{
  return std::hypot(v.x(), v.y(), v.z());
}

/// \ingroup PkgAlgebra
/// the unit vector of this direction, of however long a vector; zero for zero
inline Eigen::Vector3d stable_normalized(const Eigen::Vector3d& v)
{
  const double largest = v.cwiseAbs().maxCoeff();
  return largest > 0 ? Eigen::Vector3d((v / largest).normalized()) : v;
}

}  // namespace Conformal_geometry_processing

#endif
