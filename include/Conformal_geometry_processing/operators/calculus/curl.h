// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief curl X = -Re(D X), |F|: <del_1 X, E_2> - <del_2 X, E_1> in an oriented frame, the
/// circulation per area. ([CGP Table 3.1] has the opposite sign.)
/// \param X tangent vectors at the vertices, 3 x |V|
Eigen::VectorXd curl(const internal::Surface_derivative& d, const Points& X);

}  // namespace Conformal_geometry_processing
