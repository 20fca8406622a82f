// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief the derivative of a function along X, del_X phi = Re(X N D phi) = <X, grad phi>, |F|.
/// \param X tangent vectors on the faces, 3 x |F| \param phi |V|
Eigen::VectorXd covariant_derivative(const internal::Surface_derivative& d, const Points& X,
                                     const Eigen::VectorXd& phi);

/// \ingroup PkgOperators
/// \brief the covariant derivative of a vector field, del_X Y = (dY(X))^T, 3 x |F|: the tangential
/// part of the derivative of its coordinates in R^3 along X.
/// \param X tangent vectors on the faces, 3 x |F| \param Y tangent vectors at the vertices, 3 x |V|
Points covariant_derivative(const internal::Surface_derivative& d, const Points& X,
                            const Points& Y);

}  // namespace Conformal_geometry_processing
