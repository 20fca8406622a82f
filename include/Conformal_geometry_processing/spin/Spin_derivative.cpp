// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_derivative.h>

#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/nearness_weight.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

Spin_derivative::Spin_derivative(const Dirac_system& system, Curvature_potential potential,
                                 Quaternion_vector<double> lambda, double tolerance)
    : m_system(system),
      m_potential(std::move(potential)),
      m_lambda(std::move(lambda)),
      m_length(std::sqrt(system.squared_norm(m_lambda))),
      m_tolerance(tolerance)
{
  components(m_lambda) /= m_length;
  if (!is_eigenvector()) {
    m_diagonal = nearness_weight(system.surface()) * system.areas();
    return;
  }
  const double mu = inner_product(m_lambda, system.matrix() * m_lambda).w;
  m_diagonal = -mu * system.areas();
  if (!system.is_closed()) return;
  const Vectors form = apply_dirac_form(system.surface(), m_potential, m_lambda);
  m_gamma_gradient = form_gradient(system.surface(), m_potential.on, m_lambda) -
                     2 * apply_transpose_at_fixed_gamma(form).col(0);
}

auto Spin_derivative::apply(const Eigen::MatrixXd& changes) const -> Vectors
{
  Vectors result = apply_at_fixed_gamma(changes.rowwise() + gamma_change(changes));
  for (Quaternion<double>& q : result.reshaped()) q *= m_length;
  return result;
}

Eigen::RowVectorXd Spin_derivative::gamma_change(const Eigen::MatrixXd& changes) const
{
  if (m_gamma_gradient.size() == 0) return Eigen::RowVectorXd::Zero(changes.cols());
  return -(m_gamma_gradient.transpose() * changes) / m_gamma_gradient.sum();
}

Eigen::MatrixXd Spin_derivative::apply_transpose(const Vectors& q) const
{
  Eigen::MatrixXd result = m_length * apply_transpose_at_fixed_gamma(q);
  if (m_gamma_gradient.size() == 0) return result;
  const Eigen::RowVectorXd of_gamma = result.colwise().sum() / m_gamma_gradient.sum();
  return result - m_gamma_gradient * of_gamma;
}

auto Spin_derivative::apply_at_fixed_gamma(const Eigen::MatrixXd& changes) const -> Vectors
{
  return solve(energy_change(m_system.surface(), m_potential, m_lambda, changes));
}

Eigen::MatrixXd Spin_derivative::apply_transpose_at_fixed_gamma(const Vectors& q) const
{
  return energy_gradient(m_system.surface(), m_potential, m_lambda, solve(q));
}

auto Spin_derivative::solve(Vectors b) const -> Vectors
{
  b = m_system.projected(std::move(b));
  remove_gauge(b, true);
  const auto matrix = [this](const Vectors& x, Vectors& y) { apply_matrix(x, y); };
  const auto precondition = [this](const Vectors& r, Vectors& z) {
    z = m_system.precondition(r);
    m_solves += static_cast<int>(r.cols());
    remove_gauge(z, false);
  };
  Conjugate_gradients_options options;
  options.tolerance = m_tolerance;
  Vectors x;
  const auto result = conjugate_gradients(matrix, precondition, b, x, options);
  const double worst_error = 1e-3;  // of rounding, with slivers
  if (!result.converged && !(result.estimates.maxCoeff() <= worst_error))
    throw Solver_error("Spin_derivative", "the iterations do not converge");
  return x;
}

void Spin_derivative::apply_matrix(const Vectors& x, Vectors& y) const
{
  block_operator(m_system.matrix())(x, y);
  for (Eigen::Index k = 0; k < x.cols(); ++k)
    for (Eigen::Index i = 0; i < x.rows(); ++i) y(i, k) += m_diagonal[i] * x(i, k);
  y = m_system.projected(std::move(y));
}

void Spin_derivative::remove_gauge(Vectors& v, bool is_form) const
{
  if (!is_eigenvector()) return;
  const Eigen::VectorXd& areas = m_system.areas();
  for (Eigen::Index k = 0; k < v.cols(); ++k) {
    const Quaternion<double> share =
        reduced_to(m_system.coefficients(), is_form ? inner_product(m_lambda, v.col(k))
                                                    : inner_product(m_lambda, areas, v.col(k)));
    for (Eigen::Index i = 0; i < v.rows(); ++i)
      v(i, k) -= (is_form ? areas[i] : 1.) * (m_lambda[i] * share);
  }
}

}  // namespace Conformal_geometry_processing::internal
