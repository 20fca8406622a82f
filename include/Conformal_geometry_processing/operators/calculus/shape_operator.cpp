// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus/shape_operator.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Points shape_operator(const internal::Surface_derivative& d, const Points& X)
{
  return -d.tangential_part(d(X));
}

}  // namespace Conformal_geometry_processing
