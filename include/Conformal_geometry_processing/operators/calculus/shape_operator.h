// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_SHAPE_OPERATOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_SHAPE_OPERATOR_H

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief S X = -(D X)^T, 3 x |F|: dN = df S, the identity on the unit sphere with normals outward.
/// \param X tangent vectors at the vertices, 3 x |V|
Points shape_operator(const internal::Surface_derivative& d, const Points& X);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/operators/calculus/shape_operator_impl.h>
#endif

#endif
