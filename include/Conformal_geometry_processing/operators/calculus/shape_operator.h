// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief S X = -(D X)^T, 3 x |F|: dN = df S, the identity on the unit sphere with normals outward.
/// \param X tangent vectors at the vertices, 3 x |V|
Points shape_operator(const internal::Surface_derivative& d, const Points& X);

}  // namespace Conformal_geometry_processing
