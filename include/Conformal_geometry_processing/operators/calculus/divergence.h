// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_DIVERGENCE_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_DIVERGENCE_H

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief div X = Re(N D X), |F|: the flux out of a small circle, per area.
/// \param X tangent vectors at the vertices, 3 x |V|
Eigen::VectorXd divergence(const internal::Surface_derivative& d, const Points& X);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/operators/calculus/divergence_impl.h>
#endif

#endif
