// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing {

std::string step_fault(const Spin_report& report, bool is_turning, bool is_exact,
                       const Flow_options& options)
{
  if (!report.converged) return "the Dirac equation is not solved";
  if (report.boundary_fault == Spin_report::Boundary_fault::not_realizable && is_turning)
    return to_string(report.boundary_fault);
  if (!options.backtracking) return {};
  const double distortion = report.conformality.quasi_conformal.mean;
  if (!(distortion < options.max_step_distortion.value_or(is_exact ? 1.15 : 1.5)))
    return "the mean quasi-conformal error is " + std::to_string(distortion);
  if (!(report.closure_residual < options.max_step_closure))
    return "the closure residual is " + std::to_string(report.closure_residual);
  return {};
}

Conformal_willmore_flow::Conformal_willmore_flow(const Mesh_view& mesh, const Flow_options& options,
                                                 internal::Curvature_direction_ref direction,
                                                 std::string function)
    : m_function(std::move(function)),
      m_options(checked(options, m_function)),
      m_input(mesh),
      m_initial(on_class(mesh, options, m_function)),
      m_mesh(m_initial),
      m_next(m_initial),
      m_faces(other_faces()),
      m_transformation(m_initial, transformation_options(m_initial, options), m_function),
      m_volume(volume_constraint()),
      m_direction(m_transformation, std::move(direction), options, m_volume ? &*m_volume : nullptr,
                  m_function),
      m_balance(m_initial, options, m_transformation, m_function),
      m_initial_energy(energy_of(m_initial)),
      m_energy(m_initial_energy),
      m_least_energy_of_faces(energy_of_faces(m_initial.positions())),
      m_time_step(options.time_step, (std::min)(options.min_time_step, options.time_step),
                  options.surface.exact_conformal_class
                      ? (std::max)(options.time_step / 4,
                                   (std::min)(options.min_time_step, options.time_step))
                      : options.time_step)
{
  if (options.surface.scales.bound) m_scale_bound.emplace(m_initial, *options.surface.scales.bound);
  if (options.surface.exact_conformal_class) m_class.emplace(m_initial, options.surface.boundary);
  if (m_class && !options.surface.mollification && !m_volume && boundary_loops(mesh).empty())
    make_filter();
  if (!options.surface.mollification) return;
  m_well_shaped = well_shaped_part(m_initial);
  if (m_class) m_mollification = mollification_on_class();
}

namespace internal {

constexpr double energy_of_spheres = 4 * 3.14159265358979323846;  // the least of closed surfaces

/// makes the directions that a boundary has targets of a condition that keeps them
inline void keep_first_directions(const Mesh_view& mesh, Boundary_condition& condition)
{
  if (condition.kind != Boundary_condition::Kind::directions || condition.targets.cols() > 0)
    return;
  const Boundary_frames frames = boundary_frames(mesh);
  condition.targets.resize(3, static_cast<Eigen::Index>(frames.frames.size()));
  for (std::size_t k = 0; k < frames.frames.size(); ++k)
    condition.targets.col(static_cast<Eigen::Index>(k)) = frames.frames[k] * condition.direction;
}

}  // namespace internal

Spin_transformation_options Conformal_willmore_flow::transformation_options(
    const Mesh_view& initial, const Flow_options& options)
{
  Spin_transformation_options own = options.surface;
  own.scales = {};  // of the whole flow, see `internal::Scale_bound`
  if (!own.exact_conformal_class) return own;
  internal::keep_first_directions(initial, own.boundary);
  own.mollification.reset();  // the faces are those of `on_class()`
  own.exact_conformal_class = false;
  return own;
}

double Conformal_willmore_flow::energy_of(const Mesh_view& mesh) const
{
  const internal::Curvature_direction_ref& direction = m_direction.unconstrained();
  const Mesh_view framed = in_frame(mesh);
  if (!m_transformation.domain().is_mollified()) return direction.energy(mesh, framed);
  return direction.energy(mesh, Delaunay_view(framed, *m_options.surface.mollification));
}

Mesh_view Conformal_willmore_flow::in_frame(const Mesh_view& mesh)
{
  const Points& positions = mesh.positions();
  Mesh_view framed = mesh;  // with its edges, which need not be found again
  framed.set_positions(internal::Normalized_frame(positions).to_frame(positions));
  return framed;
}

void Conformal_willmore_flow::find_time_step(
    const internal::Constrained_direction::Result& direction, Flow_step_report& report,
    const Go_further& go_further)
{
  const bool was_filling = is_filling();
  const double first = m_time_step.value();
  const Eigen::VectorXd back = m_direction.exact_part(m_balance.potential(m_mesh));
  for (int slight_rises = 0; !report.accepted && report.stop == Flow_step_report::Stop::none;) {
    const double tau = report.time_step = m_time_step.value();
    ++report.trials;
    const double filled = keep_volume(tau / m_options.time_step);
    const Verdict verdict = try_step(
        tau * direction.v + tau / first * back + filled * direction.filling, report, go_further);
    slight_rises += verdict == Verdict::rises_slightly;
    if (verdict == Verdict::cancelled)
      report.stop = Flow_step_report::Stop::cancelled;
    else if (verdict == Verdict::good)
      accept(report, was_filling);
    else if (!m_options.backtracking)
      report.stop = verdict == Verdict::out_of_limits ? Flow_step_report::Stop::limits_reached
                                                      : Flow_step_report::Stop::step_failed;
    else if (slight_rises == 2)  // halving the step does not help: this is the minimum
      report.stop = Flow_step_report::Stop::energy_settled;
    else if (!m_time_step.halve())
      report.stop = reason_to_end(verdict, report);
  }
}

Flow_step_report::Stop Conformal_willmore_flow::reason_to_end(Verdict last,
                                                              Flow_step_report& report) const
{
  if (last == Verdict::rises_slightly || last == Verdict::rises_within_error ||
      last == Verdict::out_of_bound)
    return Flow_step_report::Stop::energy_settled;
  // Beyond e^11, the squares of the lengths by the least damping of a snap, 1e-6, exceed 16 digits;
  // from e^10 on, the next step may lead there, and may not be conformal therefore.
  const double largest_range = 10;
  const auto scale = map_to(measured(), m_mesh.positions()).scale;
  const bool is_out = m_class && !(std::log(scale.max_scale / scale.min_scale) <= largest_range);
  if (is_out) {
    const Eigen::VectorXd u = internal::vertex_log_scales(m_initial, m_mesh.positions());
    const std::string factor = "exp(" + std::to_string(-u.minCoeff()) + ")";
    (void)reject({"lengths have shrunk by a factor of " + factor, -u}, report);
    return Flow_step_report::Stop::scale_range;
  }
  return last == Verdict::out_of_limits ? Flow_step_report::Stop::limits_reached
                                        : Flow_step_report::Stop::time_step_too_small;
}

auto Conformal_willmore_flow::try_step(const Eigen::VectorXd& rho, Flow_step_report& report,
                                       const Go_further& go_further) -> Verdict
{
  try {
    return m_is_bounded ? try_at_bound(rho, report, go_further)
                        : try_within_bound(rho, report, go_further);
  } catch (const Solver_error& error) {
    if (is_out_of_memory(error)) throw;
    return reject({error.what(), internal::thinness(m_mesh)}, report);
  }
}

auto Conformal_willmore_flow::try_within_bound(const Eigen::VectorXd& rho, Flow_step_report& report,
                                               const Go_further& go_further) -> Verdict
{
  report.is_bounded = false;
  const Verdict verdict = judge_new(m_transformation.closed_step(rho, go_further), report);
  return verdict == Verdict::out_of_bound && !m_is_bounded
             ? try_bounded_step(rho, report, go_further)
             : verdict;
}

// rho may lead away from the bound by itself, as limbs move far and back again.
auto Conformal_willmore_flow::try_at_bound(const Eigen::VectorXd& rho, Flow_step_report& report,
                                           const Go_further& go_further) -> Verdict
{
  const auto is_decided = [](Verdict v) { return v == Verdict::good || v == Verdict::cancelled; };
  const Verdict bounded = try_bounded_step(rho, report, go_further);
  if (is_decided(bounded)) return bounded;
  const std::string message = report.message;
  const Flow_step_report::Place place = report.place;
  const Verdict unbounded = try_within_bound(rho, report, go_further);
  if (is_decided(unbounded)) return unbounded;
  report.message = message;
  report.place = place;
  return bounded;
}

auto Conformal_willmore_flow::try_bounded_step(const Eigen::VectorXd& rho, Flow_step_report& report,
                                               const Go_further& go_further) -> Verdict
{
  const int tries = 2;  // the second one knows what the first has missed the bound by
  const double time = report.time_step / m_options.time_step;
  report.is_bounded = true;
  for (int i = 0; i < tries; ++i) {
    auto next = m_scale_bound->step(m_transformation, m_mesh, rho, time, go_further);
    if (!next) {
      (void)reject({"no step within the bound on lengths lowers the energy", scales_of(m_mesh)},
                   report);
      return Verdict::out_of_bound;
    }
    const Verdict verdict = judge_new(std::move(*next), report);
    if (verdict == Verdict::good) m_scale_bound->learn(m_mesh.positions(), time);
    if (verdict != Verdict::out_of_bound) return verdict;
    m_scale_bound->learn(m_next.positions(), time);
  }
  return Verdict::out_of_bound;
}

auto Conformal_willmore_flow::judge_new(Spin_result result, Flow_step_report& report) -> Verdict
{
  const Spin_report before = std::exchange(report.spin, result.report);
  internal::add_costs(report.spin, before);
  if (m_class) report.spin.mollification = m_mollification;
  report.period_defect = report.spin.period_defect;
  return report.spin.cancelled ? Verdict::cancelled : judge(std::move(result), report);
}

auto Conformal_willmore_flow::judge(Spin_result result, Flow_step_report& report) -> Verdict
{
  const std::string fault = step_fault(result.report, is_turning(), m_class.has_value(), m_options);
  if (!fault.empty()) {
    const bool is_found = result.positions.cols() == m_mesh.size_of_vertices();
    return reject({fault, internal::distortion_at_vertices(
                              m_mesh, is_found ? result.positions : m_mesh.positions())},
                  report);
  }
  if (m_class && !m_class->snap(result.positions))
    return reject({"the conformal class is not reached",
                   internal::misfit_of_class(m_initial, result.positions)},
                  report);
  m_next.set_positions(std::move(result.positions));
  const double energy = energy_of(m_next), rise = energy - m_energy;
  const auto growth = [&] { return internal::energy_growth(in_frame(m_mesh), in_frame(m_next)); };
  if (!std::isfinite(energy)) return reject({"the energy is not finite", growth()}, report);
  if (keeps_directions()) report.direction_norm_after = m_direction.norm_on(m_next);
  if (rise >= forbidden_rise() && !is_of_boundary(rise, report)) {
    (void)reject({"the energy rises by " + std::to_string(rise / m_energy) + " of it", growth()},
                 report);
    if (is_small(rise, report.time_step)) return Verdict::rises_slightly;
    return is_within_error(rise, report.is_bounded) ? Verdict::rises_within_error : Verdict::bad;
  }
  return move_on(balanced(energy), spin_limits(), report);
}

double Conformal_willmore_flow::balanced(double energy)
{
  if (!m_balance.is_by_inversion()) return energy;
  const Points before = m_next.positions();
  m_next.set_positions(m_balance.inverted(m_next));
  const double after = energy_of(m_next);
  if (after - m_energy < forbidden_rise()) return after;
  m_next.set_positions(before);
  return energy;
}

bool Conformal_willmore_flow::keeps_directions() const
{
  return m_class && m_transformation.system().directions();
}

// The energy falls by the square of the direction. What a step misses of the directions at the
// boundary changes it by the first power, times the mean curvature, which is the multiplier of this
// condition: near constant mean curvature that is more.
bool Conformal_willmore_flow::is_of_boundary(double rise, const Flow_step_report& report) const
{
  const double missed = direction_error().mean + report.spin.direction_error.mean;
  return falls_at_boundary(report) &&
         rise < missed * (std::max)(m_energy, internal::energy_of_spheres);
}

bool Conformal_willmore_flow::falls_at_boundary(const Flow_step_report& report) const
{
  const double enough = .9;
  return keeps_directions() && report.direction_norm_after < enough * report.direction_norm;
}

double Conformal_willmore_flow::keep_volume(double time)
{
  if (!m_volume) return 0;
  const Points& f = m_mesh.positions();
  const double change = m_volume->change(f, time);
  m_class->keep(m_volume->equation(f, change));
  return change;
}

bool Conformal_willmore_flow::is_filling() const
{
  return m_volume &&
         std::abs(m_volume->distance(m_mesh.positions())) > Flow_report::max_missing_volume;
}

double Conformal_willmore_flow::forbidden_rise() const
{
  const bool may_rise =
      !m_options.backtracking || !m_direction.unconstrained().has_energy() || is_filling();
  return may_rise ? HUGE_VAL : turning_angle() * (std::max)(m_energy, internal::energy_of_spheres);
}

Spin_report::Direction_error Conformal_willmore_flow::direction_error() const
{
  const auto* const directions = m_transformation.system().directions();
  if (!directions) return {};
  const Points& in_frame = m_transformation.domain().mesh().positions();
  const Eigen::VectorXd errors =
      m_transformation.domain().direction_errors(*directions, in_frame, directions->targets());
  return {errors.mean(), errors.maxCoeff()};
}

auto Conformal_willmore_flow::reject(const internal::Refusal& refusal,
                                     Flow_step_report& report) const -> Verdict
{
  report.message = refusal.reason;
  report.place = internal::place_of(m_input, refusal.measure);
  return Verdict::bad;
}

Eigen::VectorXd Conformal_willmore_flow::scales_of(const Mesh_view& mesh) const
{
  return internal::vertex_log_scales(m_initial, mesh.positions()).cwiseAbs();
}

bool Conformal_willmore_flow::is_small(double change, double time) const
{
  // Near minimal surfaces, whose energy is zero, the discretisation limits the convergence.
  const double scale = (std::max)(m_energy, 0.01 * m_initial_energy);
  return std::abs(change) < m_options.energy_tolerance * time * scale;
}

bool Conformal_willmore_flow::is_within_error(double rise, bool is_bounded) const
{
  const double error_of_bounded = .01;  // relative: what they leave of the Dirac equation is rough
  return is_small(rise, 1) || (is_bounded && rise < error_of_bounded * m_energy) ||
         rise < direction_error().mean * (std::max)(m_energy, internal::energy_of_spheres);
}

auto Conformal_willmore_flow::move_on(double energy, const Conformality::Limits& limits,
                                      Flow_step_report& report) -> Verdict
{
  if (m_scale_bound && m_scale_bound->measured(m_next.positions()).excess() > 1) {
    (void)reject({"lengths have reached their bound", scales_of(m_next)}, report);
    return Verdict::out_of_bound;
  }
  const Conformality map = map_to(measured(), m_next.positions());
  if (const internal::Refusal refusal = beyond(map, limits, m_next.positions())) {
    (void)reject(refusal, report);
    return Verdict::out_of_limits;
  }
  report.quasi_conformal = map.quasi_conformal;
  report.length_cross_ratio = map.length_cross_ratio.max;
  try {
    m_transformation.set_positions(m_next.positions());
  } catch (const Precondition_error& error) {
    return reject({error.message(), internal::distortion_at_vertices(m_mesh, m_next.positions())},
                  report);
  }
  std::swap(m_mesh, m_next);
  m_energy = energy;
  return Verdict::good;
}

void Conformal_willmore_flow::accept(Flow_step_report& report, bool was_filling)
{
  ++m_steps;
  report.accepted = true;
  if (was_filling) m_least_energy_of_faces = HUGE_VAL;  // that of another volume
  tell_energy(report);
  report.message.clear();
  report.place = {};
  m_is_bounded = report.is_bounded;
  if (m_class) judge_boundary(report.spin);
  m_time_step.grow();
  const double change = report.energy - report.energy_before;
  if (m_direction.unconstrained().has_energy() && !falls_at_boundary(report) && !is_filling() &&
      is_small(change, fairs() ? 1 : report.time_step))
    report.stop = Flow_step_report::Stop::energy_settled;
}

}  // namespace Conformal_geometry_processing
