// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus/divergence.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Eigen::VectorXd divergence(const internal::Surface_derivative& d, const Points& X)
{
  return -d.normal_part(d(X));
}

}  // namespace Conformal_geometry_processing
