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

Spin_residuals few_of(const Spin_residuals& residuals)
{
  Spin_residuals few;
  for (Spin_residual* r : residuals)
    if (r->is_few()) few.push_back(r);
  return few;
}

Block<Quaternion<double>> gradients_of(const Spin_residuals& residuals, Eigen::Index vertices)
{
  Eigen::Index size = 0;
  for (const Spin_residual* r : residuals) size += r->values().size();
  Block<Quaternion<double>> all(vertices, size);
  Eigen::Index column = 0;
  for (const Spin_residual* r : residuals) {
    const Eigen::Index n = r->values().size();
    for (Eigen::Index k = 0; k < n; ++k)
      all.col(column++) = r->gradient(Eigen::VectorXd::Unit(n, k));
  }
  return all;
}

}  // namespace Conformal_geometry_processing::internal
