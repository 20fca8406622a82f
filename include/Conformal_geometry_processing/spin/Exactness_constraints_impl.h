// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_EXACTNESS_CONSTRAINTS_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_EXACTNESS_CONSTRAINTS_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

CGP_INLINE internal::Constraint_basis internal::Exactness_constraints::basis() const
{
  internal::Constraint_basis basis(areas);
  if (!constants_have_effect) basis.add(Eigen::VectorXd::Ones(areas.size()));
  basis.add(functions);
  return basis;
}

CGP_INLINE double internal::Exactness_constraints::period_defect(
    const Eigen::MatrixX3d& edges) const
{
  if (forms.size() == 0) return 0;
  // Uses |w|, because w is negative opposite large angles and then defines no norm.
  const double total = weights.cwiseAbs().dot(edges.rowwise().squaredNorm());
  return forms.coefficients(weights, edges).norm() / std::sqrt(total);
}

CGP_INLINE Eigen::VectorXd internal::Exactness_constraints::closing_change(
    const Eigen::MatrixX3d& edges, const Eigen::MatrixXd& derivative) const
{
  if (derivative.cols() == 0) return Eigen::VectorXd::Zero(areas.size());
  // By rows, so that the three axes of a form are together, as in the functions.
  const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> periods =
      forms.coefficients(weights, edges);
  const double damping = 0.01;
  Eigen::MatrixXd gram = derivative.transpose() * areas.asDiagonal() * derivative;
  gram.diagonal().array() += damping * damping * gram.diagonal().maxCoeff();
  return derivative * gram.ldlt().solve(-periods.reshaped<Eigen::RowMajor>() / 2);
}

}  // namespace Conformal_geometry_processing

#endif
