// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_GRADIENT_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_GRADIENT_H

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief grad phi = -N D phi, 3 x |F|: exactly the gradient of the function linear on every face.
/// \param phi |V|
Points gradient(const internal::Surface_derivative& d, const Eigen::VectorXd& phi);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/operators/calculus/gradient_impl.h>
#endif

#endif
