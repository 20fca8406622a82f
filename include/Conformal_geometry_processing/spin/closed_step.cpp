// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/closed_step.h>

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/period_functions.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

Closed_step measured_step(Spin_transformation& transformation, const Curvature_potential& rho,
                          const Dirac_options& options, const Go_further& go_further)
{
  const Exactness_constraints& exactness = transformation.exactness(rho.on);
  Closed_step step{transformation.trial_step(rho, options, go_further), rho, {}};
  if (step.result.report.cancelled) return step;
  step.edges = transformed_edges(transformation.system().surface(), step.result.lambda);
  step.result.report.period_defect = exactness.period_defect(step.edges);
  return step;
}

Eigen::MatrixXd period_derivative(Spin_transformation& transformation, Closed_step& step)
{
  const Exactness_constraints& exactness = transformation.exactness(step.rho.on);
  if (!transformation.turns_directions()) return exactness.functions;
  Spin_report& report = step.result.report;
  Stopwatch watch;
  auto& system = transformation.system();
  const double unit = transformation.domain().unit();
  const double gamma = system.is_self_adjoint() ? report.eigenvalue : 0;
  const Curvature_potential rho{step.rho.on, unit * (step.rho.values.array() + gamma).matrix()};
  Dirac_evidence::Seconds seconds;
  system.set_potential(rho, seconds, 1e-6);
  ++report.factorizations;
  const Quaternion_vector<double>& lambda = step.result.lambda;
  const double mass = system.squared_norm(lambda);
  // X is nearly singular along lambda, and changes along it have no effect.
  const auto respond = [&](Block<Quaternion<double>> c) -> Block<Quaternion<double>> {
    for (Eigen::Index i = 0; i < c.cols(); ++i) {
      const double share = inner_product(lambda, c.col(i)).w / mass;
      for (Eigen::Index v = 0; v < c.rows(); ++v) c(v, i) -= share * system.areas()[v] * lambda[v];
    }
    report.solves += static_cast<int>(c.cols());
    return system.solve(c);
  };
  Eigen::MatrixXd functions =
      period_functions(system.surface(), exactness.forms, rho, lambda, respond);
  report.seconds.exactness += watch.lap();
  return functions;
}

/// the smallest change of rho that closes a step to first order, in 1/length
Eigen::VectorXd change_to_close(Spin_transformation& transformation, Closed_step& step)
{
  const Eigen::MatrixXd derivative = period_derivative(transformation, step);
  return transformation.exactness(step.rho.on).closing_change(step.edges, derivative) /
         transformation.domain().unit();
}

/// how much of a change of rho, in the unit of the surface, changes the shape so little that the
/// same branch is found again: a quarter of the curvature of a sphere
inline double longest_part(const Exactness_constraints& exactness, const Eigen::VectorXd& change)
{
  const double sphere = std::sqrt(4 * std::acos(-1.));
  return 0.25 * sphere / std::sqrt(exactness.areas.dot(change.cwiseAbs2()));
}

Closed_step closed_step(Spin_transformation& transformation, const Curvature_potential& rho,
                        const Period_limit& limit, double share, const Dirac_options& options,
                        const Go_further& go_further)
{
  const Exactness_constraints& exactness = transformation.exactness(rho.on);
  const double unit = transformation.domain().unit();
  Closed_step best = measured_step(transformation, rho, options, go_further);
  const Spin_report& report = best.result.report;
  const bool turns = transformation.turns_directions();
  const double least = turns ? 1. / 64 : 1;
  Eigen::VectorXd change;
  for (double part = exactness.functions.cols() > 0 ? 1 : 0; part >= least;) {
    if (!report.converged || report.cancelled || report.period_defect <= limit(report, share))
      break;
    if (change.size() == 0) {
      change = change_to_close(transformation, best);
      if (turns) part = (std::min)(part, longest_part(exactness, unit * change));
    }
    const Curvature_potential better{rho.on, best.rho.values + part * change};
    Closed_step next = measured_step(transformation, better, options, go_further);
    const double before = report.period_defect, after = next.result.report.period_defect;
    const bool is_solved = next.result.report.converged;
    const bool improves = is_solved && after <= (1 - 0.75 * part) * before;
    if (next.result.report.cancelled || (is_solved && after < before)) {
      std::swap(best, next);
      change.resize(0);
    }
    add_costs(best.result.report, next.result.report);
    part = improves ? (std::min)(1., 2 * part) : part / 2;
  }
  return best;
}

}  // namespace Conformal_geometry_processing::internal
