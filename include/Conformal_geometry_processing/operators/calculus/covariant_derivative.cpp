// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus/covariant_derivative.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Eigen::VectorXd covariant_derivative(const internal::Surface_derivative& d, const Points& X,
                                     const Eigen::VectorXd& phi)
{
  const Quaternion_vector<double> q = d(phi);
  Eigen::VectorXd derivative(q.size());
  for (Eigen::Index f = 0; f < q.size(); ++f)
    derivative[f] = (imaginary(X.col(f)) * imaginary(d.normals().col(f)) * q[f]).w;
  return derivative;
}

Points covariant_derivative(const internal::Surface_derivative& d, const Points& X, const Points& Y)
{
  Points derivative(3, X.cols());
  for (Eigen::Index c = 0; c < 3; ++c)
    derivative.row(c) =
        covariant_derivative(d, X, Eigen::VectorXd(Y.row(c).transpose())).transpose();
  return d.tangential_part(as_quaternions(derivative));
}

}  // namespace Conformal_geometry_processing
