// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_LOG_SCALES_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_LOG_SCALES_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/log_scales.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE Eigen::VectorXd log_scales(const Quaternion_vector<double>& lambda)
{
  Eigen::VectorXd u(lambda.size());
  for (Eigen::Index i = 0; i < u.size(); ++i) u[i] = std::log(squared_norm(lambda[i]));
  return u;
}

CGP_INLINE Eigen::MatrixXd log_scale_change(const Quaternion_vector<double>& lambda,
                                            const Block<Quaternion<double>>& dlambda)
{
  Eigen::MatrixXd du(dlambda.rows(), dlambda.cols());
  for (Eigen::Index k = 0; k < du.cols(); ++k)
    for (Eigen::Index i = 0; i < du.rows(); ++i)
      du(i, k) = 2 * (conjugate(lambda[i]) * dlambda(i, k)).w / squared_norm(lambda[i]);
  return du;
}

CGP_INLINE Block<Quaternion<double>> log_scale_gradient(const Quaternion_vector<double>& lambda,
                                                        const Eigen::MatrixXd& y)
{
  Block<Quaternion<double>> q(y.rows(), y.cols());
  for (Eigen::Index k = 0; k < q.cols(); ++k)
    for (Eigen::Index i = 0; i < q.rows(); ++i)
      q(i, k) = (2 * y(i, k) / squared_norm(lambda[i])) * lambda[i];
  return q;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
