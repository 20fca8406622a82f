// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_GRADIENT_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_GRADIENT_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/calculus/gradient.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE Points gradient(const internal::Surface_derivative& d, const Eigen::VectorXd& phi)
{
  Quaternion_vector<double> q = d(phi);
  for (Eigen::Index f = 0; f < q.size(); ++f) q[f] = -imaginary(d.normals().col(f)) * q[f];
  return d.tangential_part(q);
}

}  // namespace Conformal_geometry_processing

#endif
