// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus/gradient.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Points gradient(const internal::Surface_derivative& d, const Eigen::VectorXd& phi)
{
  Quaternion_vector<double> q = d(phi);
  for (Eigen::Index f = 0; f < q.size(); ++f) q[f] = -imaginary(d.normals().col(f)) * q[f];
  return d.tangential_part(q);
}

}  // namespace Conformal_geometry_processing
