// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief Delta phi = Re(D^2 phi) at the vertices, |V|: positive semidefinite, and exactly the
/// cotan Laplacian divided by the vertex areas.
/// \param phi |V|
Eigen::VectorXd laplacian(const internal::Surface_derivative& d, const Eigen::VectorXd& phi);

/// \ingroup PkgOperators
/// \brief the Hodge Laplacian on vector fields, (D (Re DX + (DX)^N))^T at the vertices, 3 x |V|:
/// D^2 X without the contribution of S X. Positive semidefinite.
///
/// [CGP Prop 3.4.9] has only (DX)^N, which gives -grad div X.
/// \param X tangent vectors at the vertices, 3 x |V| \param normals of the vertices, 3 x |V|
Points vector_laplacian(const internal::Surface_derivative& d, const Points& X,
                        const Points& normals);

}  // namespace Conformal_geometry_processing
