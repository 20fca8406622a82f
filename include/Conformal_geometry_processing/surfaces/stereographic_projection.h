// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief Returns the stereographic projection of a point of the 3-sphere, a unit quaternion q:
/// Im q / (1 - Re q), a conformal map; 1 is mapped to infinity, -1 to the origin.
///
/// To project from another point p, multiply by its conjugate: conjugate(p) q. All these images of
/// a surface are Moebius transforms of each other.
/// \pre q has unit length and is not 1
Eigen::Vector3d stereographic_projection(const Quaternion<double>& q);

/// \ingroup PkgSurfaces
/// Returns the unit quaternion whose projection is p
Quaternion<double> inverse_stereographic_projection(const Eigen::Vector3d& p);

}  // namespace Conformal_geometry_processing
