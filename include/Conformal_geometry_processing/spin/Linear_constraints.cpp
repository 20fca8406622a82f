// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Linear_constraints.h>

#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_eigen_decomposition.h>

#include <Eigen/Core>

#include <utility>

namespace Conformal_geometry_processing::internal {

Linear_constraints::Linear_constraints(Eigen::MatrixXd gradients, Eigen::MatrixXd directions,
                                       const Eigen::VectorXd& dampings)
    : m_gradients(std::move(gradients)), m_directions(std::move(directions))
{
  if (m_gradients.cols() == 0) return;
  const double rounding = 1e-12;
  Eigen::MatrixXd gram = m_gradients.transpose() * m_directions;
  // Of constraints in another orthonormal basis it is the same.
  const double largest = hermitian_eigen_decomposition(gram).values.maxCoeff();
  gram.diagonal().array() += rounding * largest;
  m_gram.compute(gram);
  gram.diagonal() += largest * dampings.cwiseAbs2();
  m_change = gram;
  m_lu.compute(m_change);
}

void Linear_constraints::observe(const Eigen::VectorXd& c, const Eigen::VectorXd& change)
{
  if (m_gradients.cols() == 0) return;
  const Eigen::VectorXd y = m_lu.solve(c);
  const Eigen::VectorXd Gy = m_gradients.transpose() * (m_directions * y);
  m_change += (change - c) * Gy.transpose() / y.dot(Gy);
  m_lu.compute(m_change);
}

Eigen::VectorXd Linear_constraints::least_solution(const Eigen::VectorXd& c) const
{
  if (m_gradients.cols() == 0) return Eigen::VectorXd::Zero(m_gradients.rows());
  return m_directions * m_lu.solve(c);
}

Eigen::VectorXd Linear_constraints::project_out(Eigen::VectorXd d) const
{
  if (m_gradients.cols() == 0) return d;
  return d - m_directions * m_gram.solve(m_gradients.transpose() * d);
}

Eigen::VectorXd Linear_constraints::project_gradient(Eigen::VectorXd g) const
{
  if (m_gradients.cols() == 0) return g;
  return g - m_gradients * m_gram.solve(m_directions.transpose() * g);
}

}  // namespace Conformal_geometry_processing::internal
