// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief div X = Re(N D X), |F|: the flux out of a small circle, per area.
/// \param X tangent vectors at the vertices, 3 x |V|
Eigen::VectorXd divergence(const internal::Surface_derivative& d, const Points& X);

}  // namespace Conformal_geometry_processing
