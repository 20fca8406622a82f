// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_DIVERGENCE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_DIVERGENCE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/calculus/divergence.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE Eigen::VectorXd divergence(const internal::Surface_derivative& d, const Points& X)
{
  return -d.normal_part(d(X));
}

}  // namespace Conformal_geometry_processing

#endif
