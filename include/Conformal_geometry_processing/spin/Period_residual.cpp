// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Period_residual.h>

#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Spin_gauge.h>

#include <Eigen/Cholesky>

#include <utility>

namespace Conformal_geometry_processing::internal {

Period_residual::Period_residual(const Surface_ref& surface, const Exactness_constraints& exactness)
    : m_surface(surface), m_exactness(exactness)
{}

void Period_residual::set_spins(const Spins& lambda)
{
  m_lambda = lambda;
  const Eigen::MatrixX3d edges = transformed_edges(m_surface, lambda);
  m_length = std::sqrt(m_exactness.weights.cwiseAbs().dot(edges.rowwise().squaredNorm()));
  m_values = periods(edges);
}

// The length counts as constant: its change is multiplied by values that become zero.
Eigen::VectorXd Period_residual::change(const Spins& dlambda) const
{
  return std::sqrt(m_weight) * periods(edge_change(m_surface, m_lambda, dlambda));
}

auto Period_residual::gradient(const Eigen::VectorXd& y) const -> Spins
{
  return edge_gradient(m_surface, m_lambda, edge_forces(y.reshaped(y.size() / 3, 3)));
}

Spin_columns Period_residual::columns() const
{
  const Eigen::Index loops = m_exactness.forms->size();
  Spin_columns c{
      edge_gradients(m_surface, m_lambda, edge_forces(Eigen::MatrixXd::Identity(loops, loops))),
      Block<Quaternion<double>>::Constant(loops, 3 * loops, {})};
  for (int axis = 0; axis < 3; ++axis)
    c.factors.middleCols(axis * loops, loops)
        .diagonal()
        .setConstant(imaginary(Eigen::Vector3d::Unit(axis)));
  return c;
}

Eigen::MatrixXd Period_residual::edge_forces(const Eigen::MatrixXd& c) const
{
  const Eigen::VectorXd weights = std::sqrt(m_weight) / m_length * m_exactness.weights;
  return weights.asDiagonal() * m_exactness.forms->combinations(c);
}

Eigen::VectorXd Period_residual::periods(const Eigen::MatrixX3d& edges) const
{
  return m_exactness.forms->coefficients(edges).reshaped() / m_length;
}

/// the changes of rho that take off periods, and those of spins that belong to them
class Period_correction {
 public:
  using Spins = Quaternion_vector<double>;
  using Vectors = Block<Quaternion<double>>;

  /// \param rho and lambda solve the equation; \param periods at lambda
  Period_correction(const Dirac_system& system, const Eigen::VectorXd& rho, Spins lambda,
                    Period_residual& periods);

  /// d that takes off so much of the periods
  Eigen::VectorXd potential(const Eigen::VectorXd& periods) const;

  /// dl
  Spins spins(const Eigen::VectorXd& d) const
  {
    return solve(energy_change(m_system.surface(), m_rho, m_lambda, d)).col(0);
  }

  /// that have been needed: one for each loop, three where spins are real combinations
  int number_of_solves() const { return m_solves; }

 private:
  Vectors solve(Vectors g) const;

  const Dirac_system& m_system;
  Spin_gauge m_gauge;
  Curvature_potential m_rho;
  Spins m_lambda;
  Eigen::MatrixXd m_functions;  // the periods change by their products with d, in the areas
  Eigen::LDLT<Eigen::MatrixXd> m_gram;
  int m_solves;
};

// Damped: changes of rho that move the ends of the loops a hundred times less than others would
// have to be large, and are left out. Such are the noise of the function that vanishes on
// isothermic surfaces.
Period_correction::Period_correction(const Dirac_system& system, const Eigen::VectorXd& rho,
                                     Spins lambda, Period_residual& periods)
    : m_system(system),
      m_gauge(system),
      m_rho(Curvature_potential::on_vertices(rho)),
      m_lambda(std::move(lambda))
{
  const double damping = 0.01;
  const Spin_columns c = columns_of({&periods}, system.coefficients());
  m_solves = static_cast<int>(c.columns.cols());
  m_functions =
      system.areas().cwiseInverse().asDiagonal() *
      energy_gradient(system.surface(), m_rho, m_lambda, combination(solve(c.columns), c.factors));
  Eigen::MatrixXd gram = m_functions.transpose() * system.areas().asDiagonal() * m_functions;
  gram.diagonal().array() += damping * damping * gram.diagonal().maxCoeff();
  m_gram.compute(gram);
}

// At most a quarter of the curvature of a sphere: derivatives tell little of longer changes.
Eigen::VectorXd Period_correction::potential(const Eigen::VectorXd& periods) const
{
  const double longest = 0.25 * std::sqrt(4 * std::acos(-1.));
  const Eigen::VectorXd d = m_functions * m_gram.solve(-periods);
  const double length = std::sqrt(m_system.areas().dot(d.cwiseAbs2()));
  return length > longest ? d * (longest / length) : d;
}

// X is nearly singular along lambda, and changes along it have no effect.
auto Period_correction::solve(Vectors g) const -> Vectors
{
  for (Eigen::Index k = 0; k < g.cols(); ++k)
    g.col(k) = m_gauge.projected_gradient(m_lambda, g.col(k));
  Vectors y = m_system.precondition(g);
  for (Eigen::Index k = 0; k < y.cols(); ++k) y.col(k) = m_gauge.projected(m_lambda, y.col(k));
  return y;
}

/// takes a change if it takes off some of the defect; returns how much of that is left
double take_change(const Period_correction& correction, const Spin_gauge& gauge,
                   Period_residual& periods, Closed_spins& s)
{
  const Eigen::VectorXd d = correction.potential(periods.values());
  Quaternion_vector<double> next = gauge.normalized(s.lambda + correction.spins(d));
  ++s.solves;
  periods.set_spins(next);
  const double before = s.period_defect, after = periods.values().norm();
  if (!(after < before)) return 1;
  s = {std::move(next), s.rho + d, after, s.solves};
  return after / before;
}

Closed_spins closed_spins(const Dirac_system& system, const Exactness_constraints& exactness,
                          Eigen::VectorXd rho, Quaternion_vector<double> lambda, double limit)
{
  const double worst = .25;
  const Spin_gauge gauge(system);
  Closed_spins s{gauge.normalized(std::move(lambda)), std::move(rho)};
  Period_residual periods(system.surface(), exactness);
  periods.set_weight(1);  // for which the values are the defect
  periods.set_spins(s.lambda);
  s.period_defect = periods.values().norm();
  if (s.period_defect <= limit) return s;
  const Period_correction correction(system, s.rho, s.lambda, periods);
  s.solves = correction.number_of_solves();
  for (double left = 0; s.period_defect > limit && left <= worst;)
    left = take_change(correction, gauge, periods, s);
  return s;
}

}  // namespace Conformal_geometry_processing::internal
