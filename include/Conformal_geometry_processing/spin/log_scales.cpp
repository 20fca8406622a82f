// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/log_scales.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing::internal {

Eigen::VectorXd log_scales(const Quaternion_vector<double>& lambda)
{
  Eigen::VectorXd u(lambda.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = std::log(squared_norm(lambda[i]));
  return u;
}

Eigen::MatrixXd log_scale_change(const Quaternion_vector<double>& lambda,
                                 const Block<Quaternion<double>>& dlambda)
{
  Eigen::MatrixXd du(dlambda.rows(), dlambda.cols());
  for (Eigen::Index k = 0; k < du.cols(); ++k)
    for (Eigen::Index i = 0; i < du.rows(); ++i)
      du(i, k) = 2 * (conjugate(lambda[i]) * dlambda(i, k)).w / squared_norm(lambda[i]);
  return du;
}

Block<Quaternion<double>> log_scale_gradient(const Quaternion_vector<double>& lambda,
                                             const Eigen::MatrixXd& y)
{
  Block<Quaternion<double>> q(y.rows(), y.cols());
  for (Eigen::Index k = 0; k < q.cols(); ++k)
    for (Eigen::Index i = 0; i < q.rows(); ++i)
      q(i, k) = (2 * y(i, k) / squared_norm(lambda[i])) * lambda[i];
  return q;
}

}  // namespace Conformal_geometry_processing::internal
