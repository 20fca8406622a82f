// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus/curl.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Eigen::VectorXd curl(const internal::Surface_derivative& d, const Points& X)
{
  return -d.real_part(d(X));
}

}  // namespace Conformal_geometry_processing
