// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_preview.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/conjugate_gradients.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/nearness_weight.h>
#include <Conformal_geometry_processing/threads/Thread_team.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

Spin_preview::Spin_preview(Spin_transformation& transformation)
    : m_transformation(transformation),
      m_system(transformation.domain().surface(), {}, "Spin_preview",
               transformation.system().solvers())
{
  if (transformation.system().directions() || transformation.system().positions())
    throw Precondition_error("Spin_preview", "the boundary has prescribed data, it must be free");
  const auto zero =
      Curvature_potential::on_vertices(Eigen::VectorXd::Zero(m_system.areas().size()));
  Dirac_evidence::Seconds seconds;
  if (m_system.is_closed()) {
    m_system.set_preconditioner(zero, seconds);
  } else {
    m_weights = nearness_weight(m_system.surface()) * m_system.areas();
    m_system.set_potential(zero, m_weights, seconds);
  }
  restart();
}

void Spin_preview::restart()
{
  m_lambda = Quaternion_vector<double>::Constant(m_system.areas().size(), {1, 0, 0, 0});
  m_gamma = 0;
}

Spin_result Spin_preview::transform(const Curvature_potential& rho)
{
  const Thread_team team;
  m_transformation.require_potential(rho);
  Dirac_solution s;
  const Curvature_potential framed{rho.on, rho.values * m_transformation.domain().unit()};
  const Curvature_potential part = admissible(framed);
  if (m_system.is_closed())
    improve_eigenvector(part, s);
  else
    improve_nearest(part, s);
  s.eigenvalue = m_system.is_closed() ? dirac_quotient(m_system.surface(), framed, m_lambda)
                                      : dirac_misfit(m_system.surface(), framed, m_lambda);
  s.overlap = m_system.overlap_with_identity(m_lambda);
  Spin_result result = m_transformation.integrate(m_lambda);
  static_cast<Dirac_evidence&>(result.report) = in_units(s, m_transformation.domain().unit());
  static_cast<Dirac_evidence::Seconds&>(result.report.seconds) = s.seconds;
  add_costs(result.report, m_transformation.take_unreported());
  return result;
}

Curvature_potential Spin_preview::admissible(const Curvature_potential& rho)
{
  return {rho.on, m_transformation.exactness(rho.on).basis().project_out(rho.values)};
}

// The first pass tells gamma well enough for the second, whose lambda is then that of X(rho +
// gamma), as for `Dirac_branch`.
void Spin_preview::improve_eigenvector(const Curvature_potential& rho, Dirac_solution& s)
{
  iterate(rho, 10 * tolerance, max_solves / 2, s);
  iterate(rho, tolerance, max_solves - s.solves, s);
  m_lambda = m_system.normalized(std::move(m_lambda));
  s.converged = s.residual <= tolerance;
}

void Spin_preview::iterate(const Curvature_potential& rho, double accuracy, int solves,
                           Dirac_solution& s)
{
  const Curvature_potential shifted{rho.on, (rho.values.array() + m_gamma).matrix()};
  m_system.assemble(shifted, s.seconds);
  Stopwatch watch;
  Eigensolver_options options;
  options.tolerance = accuracy;
  options.max_iterations = solves - 1;  // and one that measures the error
  options.scale = std::sqrt(m_system.unit());
  const Eigensolver_result r = Eigensolver_ref()(m_system.matrix(), m_system.areas(),
                                                 m_system.solver(), Vectors(m_lambda), options);
  m_lambda = r.vectors.col(0);
  m_gamma += dirac_quotient(m_system.surface(), shifted, m_lambda);
  s.residual = r.estimates[0];
  s.iterations += r.iterations;
  s.solves += r.solves;
  s.seconds.eigenvectors += watch.lap();
}

void Spin_preview::improve_nearest(const Curvature_potential& rho, Dirac_solution& s)
{
  m_system.assemble(rho, s.seconds);
  Stopwatch watch;
  const auto apply = [this](const Vectors& x) {
    Vectors y = block_operator(m_system.matrix())(x);
    for (Eigen::Index i = 0; i < y.rows(); ++i) y(i, 0) += m_weights[i] * x(i, 0);
    return y;
  };
  const auto rest = [&] {  // of the equation (X + W) lambda = W 1
    Vectors r = -apply(m_lambda);
    for (Eigen::Index i = 0; i < r.rows(); ++i) r(i, 0).w += m_weights[i];
    return r;
  };
  const auto invert = inverse_operator(m_system.solver());
  const auto precondition = [&](const Vectors& r, Vectors& z) {
    invert(r, z);
    ++s.solves;
  };
  Vectors change;
  const auto r =
      conjugate_gradients(apply, precondition, rest(), change, {tolerance, max_solves - 1});
  m_lambda += change.col(0);
  s.iterations = r.iterations;
  s.residual = components(Quaternion_vector<double>(rest().col(0))).norm() / m_weights.norm();
  s.converged = r.converged;
  s.seconds.eigenvectors += watch.lap();
}

}  // namespace Conformal_geometry_processing::internal
