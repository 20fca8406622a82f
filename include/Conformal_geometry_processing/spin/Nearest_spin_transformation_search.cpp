// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The search for the surface nearest to a target.
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/spin/Relaxed_positions.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// every vertex, with its place in targets
std::vector<Control_point> vertices_as_control_points(const Points& targets)
{
  std::vector<Control_point> points;
  for (int v = 0; v < targets.cols(); ++v) points.push_back(control_point(v, targets.col(v)));
  return points;
}

/// few steps for each weight, since the next one asks for more; a bound on lengths needs some
Relaxed_scales_options steps_of_a_weight(bool is_bounded)
{
  Relaxed_scales_options options;
  options.max_steps = is_bounded ? 8 : 3;
  options.least_gain = .1;
  return options;
}

/// the weight of distances d by R that asks for less of them, but not for all at once
double first_weight(double d)
{
  const double least = 10, most = 1e6;
  return std::clamp(1 / (d * d), least, most);
}

}  // namespace internal

auto Nearest_spin_transformation::positions_from(const Nearest_spin_result& start)
    -> std::unique_ptr<Search>
{
  const internal::Framed_surface& domain = m_transformation->domain();
  internal::Dirac_system& system = m_transformation->system();
  // The size of the target must not weigh distances against rho.
  const Points target = domain.frame().to_frame(
      align(m_target, m_transformation->positions(), system.areas()).apply(m_target));
  const Eigen::VectorXd rho =
      domain.unit() * internal::values_at_vertices(domain.mesh(), start.rho);
  auto search = std::make_unique<Search>(
      *m_transformation,
      Search::Problem{internal::vertices_as_control_points(target),
                      system.areas() / system.areas().sum(), rho, m_options.surface.scales, 1},
      target, internal::steps_of_a_weight(m_options.surface.scales.bound.has_value()));
  search->restart({start.lambda, rho, start.report.scales.weight, start.report.scales.excess()});
  return search;
}

Nearest_spin_result Nearest_spin_transformation::searched(Nearest_spin_result start,
                                                          const internal::Go_further& go_further)
{
  if (!start.report.converged) return start;
  const auto is_reached = [&](const Nearest_spin_result& r) {
    return r.report && m_mismatch.is_reached(r.distance, r.normal_distance);
  };
  if (is_reached(start)) return start;
  const std::unique_ptr<Search> search = positions_from(start);
  const auto sum = [&](const Nearest_spin_result& r) {
    return m_mismatch.sum(r.distance, r.normal_distance);
  };
  const double last_weight = 2e7, least_factor = 1.3, much_worse = 1.3, shear = .05;
  // A bound shears, which is not a measure of what the mesh leaves.
  const double of_mesh = m_options.surface.scales.bound ? 0 : start.report.closure_residual;
  const double most_sheared =
      m_options.shear.value_or(m_options.normal_weight == 0 ? start.report.limits.closure
                                                            : (std::max)(shear, 1.5 * of_mesh));
  double factor = 8, nearest = std::numeric_limits<double>::infinity();
  Nearest_spin_result best = std::move(start);
  Search::State state = search->state();
  for (double w = internal::first_weight(search->distance());
       w <= last_weight && factor > least_factor && !is_reached(best) &&
       !search->scales().is_spent();
       w *= factor) {
    search->set_weight(w);
    const bool is_cancelled = search->go_on(go_further) == internal::Relaxed_scales::End::cancelled;
    Nearest_spin_result next = is_cancelled ? Nearest_spin_result{} : present(*search);
    if (is_cancelled) {
      best.report.cancelled = true;
      break;
    }
    const bool is_good = next.report && next.report.closure_residual <= most_sheared;
    // A larger weight helps, also where the first of them led away from the start.
    const bool is_near = sum(next) <= much_worse * nearest;
    if (is_good) nearest = (std::min)(nearest, sum(next));
    if (is_good && is_better(next, best)) {
      std::swap(best, next);
      state = search->state();
    } else if (!is_good || !is_near) {
      search->restart(state);
      w /= factor;
      factor = std::sqrt(factor);
    }
    add_costs(best.report, next.report);
  }
  add_costs(best.report, m_transformation->take_unreported());
  return best;
}

bool Nearest_spin_transformation::is_better(const Nearest_spin_result& next,
                                            const Nearest_spin_result& best) const
{
  return next.report && next.distance <= next.source_distance &&
         (!best.report || m_mismatch.sum(next.distance, next.normal_distance) <
                              m_mismatch.sum(best.distance, best.normal_distance));
}

Nearest_spin_result Nearest_spin_transformation::present(Search& search)
{
  Spin_result found = search.present();
  search.reset_costs();
  if (found.positions.size() > 0) align_spins(found.lambda);
  return placed(std::move(found),
                Curvature_potential::on_vertices(search.scales().spins().rho() /
                                                 m_transformation->domain().unit()));
}

}  // namespace Conformal_geometry_processing
