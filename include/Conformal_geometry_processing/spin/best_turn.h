// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the rotation that best turns directions U into V: the unit quaternion q that minimises
/// sum |U q - q V|^2; of several that fit about equally well (all U may be nearly parallel to one
/// line), the one nearest to 1.
/// \param U, V unit vectors, 3 x n with n > 0
Quaternion<double> best_turn(const Points& U, const Points& V);

}  // namespace Conformal_geometry_processing
