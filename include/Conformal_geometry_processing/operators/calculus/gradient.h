// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief grad phi = -N D phi, 3 x |F|: exactly the gradient of the function linear on every face.
/// \param phi |V|
Points gradient(const internal::Surface_derivative& d, const Eigen::VectorXd& phi);

}  // namespace Conformal_geometry_processing
