// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

Eigen::VectorXd values_at(const Spin_residual::Spins& lambda, const Spin_residuals& residuals)
{
  Eigen::VectorXd all;
  for (Spin_residual* r : residuals) {
    r->set_spins(lambda);
    const Eigen::VectorXd some = r->values();
    all.conservativeResize(all.size() + some.size());
    all.tail(some.size()) = some;
  }
  return all;
}

Eigen::VectorXd dampings_of(const Spin_residuals& residuals)
{
  Eigen::VectorXd all;
  for (const Spin_residual* r : residuals) {
    const Eigen::Index n = r->values().size();
    all.conservativeResize(all.size() + n);
    all.tail(n).setConstant(r->damping());
  }
  return all;
}

Block<Quaternion<double>> gradients_of(const Spin_residuals& residuals, Eigen::Index vertices)
{
  Block<Quaternion<double>> all(vertices, dampings_of(residuals).size());
  Eigen::Index column = 0;
  for (const Spin_residual* r : residuals) {
    const Eigen::Index n = r->values().size();
    for (Eigen::Index k = 0; k < n; ++k)
      all.col(column++) = r->gradient(Eigen::VectorXd::Unit(n, k));
  }
  return all;
}

}  // namespace Conformal_geometry_processing::internal
