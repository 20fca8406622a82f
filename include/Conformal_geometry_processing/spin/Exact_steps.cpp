// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Exact_steps.h>

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/spin/Framed_surface.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/certify.h>
#include <Conformal_geometry_processing/spin/closed_step.h>
#include <Conformal_geometry_processing/spin/gauge.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace Conformal_geometry_processing::internal {

Exact_steps::Exact_steps(Spin_transformation& transformation, const Curvature_potential& rho,
                         const Spin_transformation_options& options)
    : m_transformation(transformation),
      m_options(options),
      m_limit{options.max_period_defect},
      m_frame(transformation.domain().frame()),
      m_before(transformation.domain().measured()),
      m_missing(rho),
      m_wanted(rho.values),
      m_left_out(Eigen::VectorXd::Zero(rho.values.size())),
      m_areas(areas()),
      m_vertex_areas(transformation.system().areas())
{
  const auto* const directions = transformation.system().directions();
  if (directions) m_directions = directions->targets();
}

Spin_result Exact_steps::run(const Dirac_options& options, const Go_further& go_further)
{
  m_limit.tolerance = options.tolerance;
  Spin_result all;
  all.lambda = Quaternion_vector<double>::Constant(m_before.size_of_vertices(), {1, 0, 0, 0});
  all.report.limits = m_transformation.limits();
  all.report.steps = 0;
  all.report.reached = 0;
  go_all_the_way(options, go_further, all);
  if (all.report.steps > 0) finish(all);
  tell_shares(all.report);
  return all;
}

// Rho that turning the boundary adds has nothing to do with the given one, and takes away from it
// by chance only.
void Exact_steps::tell_shares(Spin_report& report) const
{
  const double wanted = norm(m_wanted), sphere = std::sqrt(4 * std::acos(-1.));
  const Eigen::VectorXd lacking = m_left_out + m_missing.values;
  if (!m_transformation.turns_directions()) {
    if (wanted > 0) report.missing_share = norm(lacking) / wanted;
    if (wanted > 0) report.realised_share = norm(m_wanted - lacking) / wanted;
    return;
  }
  const double along =
      wanted > 0 ? m_areas.dot(lacking.cwiseProduct(m_wanted)) / (wanted * wanted) : 0;
  report.missing_share = std::clamp(along, 0., 1.);
  report.realised_share = (std::min)(report.reached, 1 - report.missing_share);
  report.added_share = norm(lacking - report.missing_share * m_wanted) / sphere;
}

void Exact_steps::go_all_the_way(const Dirac_options& options, const Go_further& go_further,
                                 Spin_result& all)
{
  for (double step = 1; step > 0;) {
    const std::optional<Eigen::VectorXd> exact = exact_part(all.report.steps > 0);
    if (!exact) return;
    const Eigen::VectorXd& v = *exact;
    const double rest = 1 - all.report.reached;
    std::optional<Closed_step> next = largest_step(v / rest, options, go_further, all.report, step);
    if (!next) return;
    take(v, step / rest, next->rho.values);
    for (Eigen::Index i = 0; i < all.lambda.size(); ++i)
      all.lambda[i] = all.lambda[i] * next->result.lambda[i];
    all.positions = std::move(next->result.positions);
    append(all.report, next->result.report);
    all.report.reached += step;
    step = next_step(step, next->result.report, 1 - all.report.reached);
    if (step > 0 && exceeds_bound_by_far(all.lambda, m_vertex_areas, m_options.scales)) return;
  }
  all.report.reached = 1;  // up to rounding
}

// A surface that has degenerated so far that its forms are dependent ends the way.
std::optional<Eigen::VectorXd> Exact_steps::exact_part(bool has_moved)
{
  // The periods that come from turning the boundary are not orthogonal to all of the rest.
  if (!has_moved && m_transformation.turns_directions()) return m_missing.values;
  try {
    return m_transformation.exactness(m_missing.on).basis().project_out(m_missing.values);
  } catch (const Precondition_error&) {
    if (!has_moved) throw;
    return std::nullopt;
  }
}

std::optional<Closed_step> Exact_steps::largest_step(const Eigen::VectorXd& v,
                                                     const Dirac_options& options,
                                                     const Go_further& go_further, Spin_report& all,
                                                     double& step)
{
  for (;;) {
    Closed_step next =
        closed_step(m_transformation, {m_missing.on, step * v}, m_limit, step, options, go_further);
    const Spin_report& report = next.result.report;
    const bool is_good =
        !report.cancelled && report.converged && report.period_defect <= m_limit(report, step);
    const bool is_end = next_step(step, report, 1 - all.reached - step) == 0;
    if (is_good && can_go_on_from(next.result.positions, is_end)) return next;
    add_costs(all, report);
    if (all.steps == 0) all.seconds.setup = report.seconds.setup;
    all.cancelled = report.cancelled;
    if (all.cancelled) return std::nullopt;
    if (step <= m_options.min_step) {
      if (all.steps == 0) all.boundary_fault = report.boundary_fault;
      if (all.steps == 0) all.mollification = report.mollification;
      return std::nullopt;
    }
    const double better = report.converged && !is_good ? best_step(step, report) : 0;
    step = (std::max)(m_options.min_step, std::clamp(better, step / 8, step / 2));
  }
}

// Faces that degenerate during the steps are not an error in the caller's mesh.
bool Exact_steps::can_go_on_from(const Points& positions, bool is_end)
{
  const Framed_surface& domain = m_transformation.domain();
  try {
    if (is_end)
      Framed_surface::require_faces({positions, domain.mesh().corners()}, domain.is_mollified(),
                                    "Exact_steps");
    else
      m_transformation.set_positions(positions);
  } catch (const Precondition_error&) {
    return false;
  }
  return true;
}

// Defects grow with the square of the step, or faster if they were removed to first order, but the
// share of them allowed for a step grows linearly.
double Exact_steps::best_step(double step, const Spin_report& report) const
{
  const double caution = 0.8;
  return caution * step * m_limit(report, step) / report.period_defect;
}

// At least the minimal step and at most twice the last one; avoids a tiny last step.
double Exact_steps::next_step(double step, const Spin_report& report, double rest) const
{
  const double rounding = 1e-12;
  if (rest < rounding) return 0;
  const double better = (std::min)(best_step(step, report), 2 * step);
  const double next = (std::max)(better, m_options.min_step);
  return rest - next < m_options.min_step ? rest : next;
}

void Exact_steps::take(const Eigen::VectorXd& v, double share, const Eigen::VectorXd& rho)
{
  const Eigen::VectorXd now = areas(), shrinking = m_areas.cwiseQuotient(now).cwiseSqrt();
  m_areas = now;
  const Eigen::VectorXd rest = (1 - share) * v;
  m_left_out = shrinking.cwiseProduct(m_left_out + m_missing.values - rho - rest);
  m_missing.values = shrinking.cwiseProduct(rest);
  m_wanted = shrinking.cwiseProduct(m_wanted);
}

// Each step keeps the area of its own faces; all together keep that of the first.
void Exact_steps::finish(Spin_result& all) const
{
  Points f = m_frame.to_frame(all.positions);
  restore_area(m_before, f, all.lambda);
  all.positions = m_frame.from_frame(f);
  f = m_frame.to_frame(all.positions);  // after rounding
  if (all.report.steps > 1)
    all.report.closure_residual = closure_residual(m_before, cotan_weights(m_before), f,
                                                   transformed_edges(m_before, all.lambda));
  certify(m_before, f, all.lambda, all.report);
  measure_directions(all.positions, all.report);
}

Eigen::VectorXd Exact_steps::areas() const
{
  const double unit = m_transformation.domain().unit();
  return unit * unit * curvature_areas(m_transformation.system().surface(), m_missing.on);
}

void Exact_steps::measure_directions(const Points& positions, Spin_report& report) const
{
  const auto* const directions = m_transformation.system().directions();
  if (!directions) return;
  const Framed_surface& domain = m_transformation.domain();
  const Eigen::VectorXd errors =
      domain.direction_errors(*directions, domain.frame().to_frame(positions), m_directions);
  report.direction_error = {errors.mean(), errors.maxCoeff()};
}

double Exact_steps::norm(const Eigen::VectorXd& rho) const
{
  const bool has_effect = !m_transformation.system().is_self_adjoint();
  const double mean = has_effect ? 0 : m_areas.dot(rho) / m_areas.sum();
  const double square = m_areas.dot((rho.array() - mean).square().matrix());
  // What is left of a constant is the rounding of its mean.
  const double rounding = 1e-12 * mean;
  return square > m_areas.sum() * rounding * rounding ? std::sqrt(square) : 0;
}

}  // namespace Conformal_geometry_processing::internal
