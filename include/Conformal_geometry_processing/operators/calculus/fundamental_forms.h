// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief the first fundamental form, I(X, Y) = -Re(X Y) = <X, Y>: one number for each column.
Eigen::VectorXd first_fundamental_form(const Points& X, const Points& Y);

/// \ingroup PkgOperators
/// \brief the second fundamental form, II(X, Y) = Re(Y D X) = <S X, Y>, |F|: positive on the unit
/// sphere. (Minus the form that [CGP 2.2] defines, whose sign is inconsistent with the rest of it.)
/// \param X tangent vectors at the vertices, 3 x |V| \param Y tangent vectors on the faces, 3 x |F|
Eigen::VectorXd second_fundamental_form(const internal::Surface_derivative& d, const Points& X,
                                        const Points& Y);

}  // namespace Conformal_geometry_processing
