// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// The steps of `Conformal_willmore_flow` on the exact conformal class, and what is measured of it.
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include <Conformal_geometry_processing/forms/conformal_modulus.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Intrinsic_triangulation.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

Mesh_view Conformal_willmore_flow::on_class(const Mesh_view& mesh, const Flow_options& options,
                                            const std::string& function)
{
  internal::Framed_surface::require(mesh, options.surface.mollification, function);
  if (!options.surface.exact_conformal_class) return mesh;
  if (!options.surface.mollification) return internal::simple_delaunay(mesh);
  const double share = *options.surface.mollification;
  Mesh_view opened = internal::with_opened_faces(internal::simple_delaunay(mesh, share), share);
  require_surface(opened, function);
  return opened;
}

std::optional<internal::Volume_constraint> Conformal_willmore_flow::volume_constraint() const
{
  if (!m_options.reduced_volume) return std::nullopt;
  return internal::Volume_constraint(m_input, *m_options.reduced_volume, m_function);
}

std::optional<Mesh_view> Conformal_willmore_flow::other_faces() const
{
  if (m_initial.corners() == m_input.corners()) return std::nullopt;
  return m_options.surface.mollification ? well_shaped_part(m_input).mesh : m_input;
}

void Conformal_willmore_flow::make_filter()
{
  try {
    m_filter.emplace(in_frame(m_input), m_options.surface.solvers);
  } catch (const Solver_error& error) {
    if (is_out_of_memory(error)) throw;
  }
}

auto Conformal_willmore_flow::written(const Points& found) const -> const Written&
{
  const bool has_energy = !m_options.surface.mollification;  // else that of the flow, of any points
  if (has_energy && m_written && m_written->found == found) return *m_written;
  m_written = Written{found, found, energy_of_faces(found)};
  if (m_filter) settle(*m_written);
  return *m_written;
}

void Conformal_willmore_flow::settle(Written& result) const
{
  const double error = rises_on_faces(result.energy) ? 0 : .05;  // of good faces
  Points settled = m_filter->settled(result.found);
  const double energy = energy_of_faces(settled);
  if (!(energy < (1 - error) * result.energy)) return;
  if (m_scale_bound && m_scale_bound->measured(settled).excess() > 1) return;
  const auto fault = map_to(faces(), settled).fault(m_options.surface.limits.map);
  if (fault == Conformality::Fault::none) result = {result.found, std::move(settled), energy};
}

Mesh_view Conformal_willmore_flow::shown() const
{
  Mesh_view shown = m_mesh;
  shown.set_positions(positions());
  return shown;
}

double Conformal_willmore_flow::energy_of_faces(const Points& positions) const
{
  const bool is_of_flow = !m_faces && positions == m_mesh.positions();
  if (is_of_flow || m_options.surface.mollification) return m_energy;
  Mesh_view mesh = faces();
  mesh.set_positions(positions);
  return energy_of(mesh);
}

internal::Refusal Conformal_willmore_flow::beyond(const Conformality& map,
                                                  const Conformality::Limits& limits,
                                                  const Points& found) const
{
  using internal::Refusal;
  if (Refusal refusal = internal::beyond_limits(measured(), found, map, limits)) return refusal;
  if (!m_faces) return {};
  const std::string where = " on the faces of the input, which are not Delaunay";
  const Written& result = written(found);
  Refusal of_faces = internal::beyond_limits(
      *m_faces, result.positions, map_to(*m_faces, result.positions), m_options.surface.limits.map);
  if (of_faces) return {of_faces.reason + where, of_faces.measure};
  if (m_options.surface.mollification) return {};
  if (!rises_on_faces(result.energy)) return {};
  Mesh_view before = *m_faces, after = *m_faces;
  before.set_positions(m_mesh.positions());
  after.set_positions(result.positions);
  return {"the energy rises" + where, internal::energy_growth(in_frame(before), in_frame(after))};
}

bool Conformal_willmore_flow::rises_on_faces(double energy) const
{
  const double error = .01;  // on thin faces
  return energy - m_least_energy_of_faces > forbidden_rise() + error * m_least_energy_of_faces;
}

void Conformal_willmore_flow::tell_energy(Flow_step_report& report)
{
  report.energy = m_energy;
  report.energy_of_faces = written_energy();
  m_least_energy_of_faces = (std::min)(m_least_energy_of_faces, report.energy_of_faces);
}

bool Conformal_willmore_flow::fairs() const
{
  return m_class && m_options.fairing && m_options.backtracking && m_options.filter_weight == 0 &&
         m_direction.unconstrained().has_energy();
}

void Conformal_willmore_flow::take_step(Flow_step_report& report, const Go_further& go_further)
{
  using Stop = Flow_step_report::Stop;
  (void)keep_volume(0);
  const bool pauses = fairs() && m_smoothing.pause.holds();
  report.faired = fairs() && !pauses && fair(report);
  const double smoothed = m_energy;
  transform(report, go_further);
  if (report.stop == Stop::cancelled) return;
  if (fairs() && !pauses) {
    const bool gains_more = report.energy_before - smoothed > smoothed - m_energy;
    m_smoothing.pause.learn(m_transformation.system().is_closed() ? gains_more : report.faired);
  }
  if (pauses && report.stop != Stop::none) end_pause(report);
  const bool is_last = report.stop == Stop::limits_reached && leaves_room();
  if (is_last && is_small(report.energy_before - m_energy, 1)) go_to_limits(report, go_further);
  if (report.stop == Stop::cancelled) return;
  if (report.faired && !report.accepted) settle_for_fairing(report);
}

void Conformal_willmore_flow::go_to_limits(Flow_step_report& report, const Go_further& go_further)
{
  m_smoothing.has_settled = true;
  m_time_step = *std::exchange(m_smoothing.time_step, std::nullopt);
  report.stop = Flow_step_report::Stop::none;
  transform(report, go_further);
}

void Conformal_willmore_flow::end_pause(Flow_step_report& report)
{
  m_smoothing.pause.end();
  report.faired = fair(report);
  if (!report.faired || !report.accepted) return;
  if (!is_small(report.energy_before - m_energy, 1)) report.stop = Flow_step_report::Stop::none;
  tell_energy(report);
}

void Conformal_willmore_flow::transform(Flow_step_report& report, const Go_further& go_further)
{
  const internal::Time_step before = m_time_step;
  const auto direction = m_direction(m_mesh);
  report.direction_norm = direction.norm;
  report.remaining_share = direction.share;
  report.spin.factorizations += direction.factorizations;
  report.spin.solves += direction.solves;
  if (direction.has_vanished(m_options.direction_tolerance) && !is_turning() && !is_filling())
    report.stop = Flow_step_report::Stop::direction_vanished;
  else
    find_time_step(direction, report, go_further);
  if (report.accepted)
    m_smoothing.time_step.reset();
  else if (report.stop == Flow_step_report::Stop::limits_reached && !m_smoothing.time_step)
    m_smoothing.time_step = before;
}

bool Conformal_willmore_flow::fair(Flow_step_report& report)
{
  const double before = m_energy;
  double energy = before;
  const auto is_better = [&](const Points& f) {
    m_next.set_positions(f);
    energy = energy_of(m_next);
    return energy < m_energy &&
           move_on(energy, m_options.surface.limits.map, report) == Verdict::good;
  };
  const bool is_faired = m_class->smoothed(m_mesh, is_better).has_value();
  if (!is_small(before - m_energy, 1)) m_smoothing.has_settled = false;
  return is_faired;
}

void Conformal_willmore_flow::settle_for_fairing(Flow_step_report& report)
{
  const bool was_enough = !is_small(report.energy_before - m_energy, 1);
  if (was_enough) {
    report.stop = Flow_step_report::Stop::none;
    report.message.clear();
    report.place = {};
  }
  ++m_steps;
  report.accepted = true;
  tell_energy(report);
  report.time_step = 0;
  report.direction_norm_after = report.direction_norm;
  report.is_bounded = false;
  const Spin_report given_up = std::exchange(report.spin, {});
  internal::add_costs(report.spin, given_up);
  report.spin.mollification = m_mollification;
  judge_boundary(report.spin);
}

// That a step has not realised its rho is not a fault of a surface that is in the class and has the
// directions.
void Conformal_willmore_flow::judge_boundary(Spin_report& report) const
{
  report.direction_error = direction_error();
  const bool is_of_rho = report.boundary_fault == Spin_report::Boundary_fault::not_realizable;
  if (is_of_rho && !is_turning()) report.boundary_fault = Spin_report::Boundary_fault::none;
}

auto Conformal_willmore_flow::state() const -> State
{
  return {m_mesh.positions(),
          m_energy,
          m_time_step,
          m_smoothing,
          m_class ? std::optional(m_class->state()) : std::nullopt,
          m_scale_bound ? m_scale_bound->pace() : internal::Scale_bound::Pace()};
}

void Conformal_willmore_flow::restore(const State& before)
{
  m_time_step = before.time_step;
  m_smoothing = before.smoothing;
  if (m_class) m_class->set_state(*before.keeper);
  if (m_scale_bound) m_scale_bound->set_pace(before.pace);
  if (m_mesh.positions() == before.positions) return;
  m_mesh.set_positions(before.positions);
  m_transformation.set_positions(before.positions);
  m_energy = before.energy;
}

namespace internal {

inline double largest_period_defect(const Flow_report& report)
{
  double largest = 0;
  for (const Flow_step_report& step : report.steps)
    largest = (std::max)(largest, step.period_defect);
  return largest;
}

}  // namespace internal

void Conformal_willmore_flow::finish(Flow_report& report)
{
  if (m_class && m_steps > 0 && report.stop != Flow_step_report::Stop::cancelled) polish();
  report.energy = m_energy;
  if (m_class) report.period_defect = internal::largest_period_defect(report);
  report.conformality = map_to(measured(), m_mesh.positions());
  report.conformality_of_faces = map_to(faces(), positions());
  report.energy_of_faces = written_energy();
  if (boundary_loops(m_input).empty()) {
    report.initial_enclosure = enclosure(m_input);
    report.enclosure = enclosure(Mesh_view(positions(), m_input.corners()));
  }
  if (m_volume) report.missing_volume = m_volume->distance(m_mesh.positions());
  if (m_scale_bound) report.scales = m_scale_bound->measured(m_mesh.positions());
  const bool is_triangulated = m_transformation.domain().is_mollified();
  if (m_steps > 0 && !is_triangulated && boundary_loops(m_mesh).empty())
    report.conformal_type_change = type_change();
}

double Conformal_willmore_flow::type_change() const
{
  try {
    return internal::conformal_type_distance(internal::harmonic_energies(in_frame(m_initial)),
                                             internal::harmonic_energies(in_frame(m_mesh)));
  } catch (const Solver_error& error) {
    if (is_out_of_memory(error)) throw;
    return HUGE_VAL;  // a Laplacian that cannot be factored has no harmonic forms to compare
  }
}

// Where that fails, or leaves the limits, the surface is in its class to the tolerance of the
// steps.
void Conformal_willmore_flow::polish()
{
  Points f = m_mesh.positions();
  try {
    (void)keep_volume(is_filling() ? 0 : 1);
    m_class->polish(f);
    if (beyond(map_to(measured(), f), m_options.surface.limits.map, f)) return;
    m_transformation.set_positions(f);
  } catch (const Error&) {
    return;
  }
  m_mesh.set_positions(std::move(f));
  m_energy = energy_of(m_mesh);
}

internal::Well_shaped_faces Conformal_willmore_flow::well_shaped_part(const Mesh_view& mesh)
{
  internal::Well_shaped_faces part = well_shaped_faces(in_frame(mesh));
  part.mesh.set_positions(mesh.positions());
  return part;
}

Spin_report::Mollification Conformal_willmore_flow::mollification_on_class() const
{
  const double share = *m_options.surface.mollification;
  const std::set<std::array<int, 2>> edges(m_input.ends().begin(), m_input.ends().end());
  Spin_report::Mollification made;
  made.share = share;
  made.thin_faces = mollified_lengths(in_frame(m_input), share).thin_faces;
  for (const auto& ends : m_initial.ends())
    made.flipped_edges += static_cast<int>(1 - edges.count(ends));
  made.measured_faces = m_well_shaped->mesh.size_of_faces();
  made.measured_area = m_well_shaped->share;
  return made;
}

Conformality Conformal_willmore_flow::map_to(const Mesh_view& measured, const Points& positions)
{
  const double unit = internal::Normalized_frame(measured.positions()).unit();
  Mesh_view before = measured;
  before.set_positions(measured.positions() / unit);
  const Points after = positions / unit;
  return conformality(before, after, neighbourhood_normals(before, after));
}

bool Conformal_willmore_flow::leaves_room() const
{
  return fairs() && !m_smoothing.has_settled && !m_scale_bound;
}

Conformality::Limits Conformal_willmore_flow::spin_limits() const
{
  Conformality::Limits limits = m_options.surface.limits.map;
  if (leaves_room())
    limits.quasi_conformal = (std::min)(limits.quasi_conformal, m_options.max_spin_distortion);
  return limits;
}

}  // namespace Conformal_geometry_processing
