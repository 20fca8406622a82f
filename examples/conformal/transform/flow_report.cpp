// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "flow_report.h"

#include "conformal/process/text.h"
#include "conformal/report/certificate.h"

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <cmath>

namespace conformal {
namespace {

const double energy_of_sphere = 4 * std::acos(-1.);

/// the mean distance of the surface from its centroid, and its standard deviation by the mean
struct Radius {
  double mean, deviation;
};

Radius radius(const CGP::Mesh_view& mesh)
{
  const Eigen::VectorXd weights = CGP::vertex_areas(mesh) / CGP::vertex_areas(mesh).sum();
  const Eigen::Vector3d center = mesh.positions() * weights;
  const Eigen::VectorXd r = (mesh.positions().colwise() - center).colwise().norm();
  const double mean = r.dot(weights);
  return {mean, std::sqrt((r.array() - mean).square().matrix().dot(weights)) / mean};
}

void report_distribution(const CGP::internal::Distribution& d, const std::string& place,
                         Report& report)
{
  report.set(place + "/mean", d.mean);
  report.set(place + "/p99", d.p99);
  report.set(place + "/max", d.max);
}

void report_step(const CGP::Flow_step_report& step, const std::string& place, Report& report)
{
  report.set(place + "/step", step.step);
  report.set(place + "/energy", step.energy_of_faces);
  report.set(place + "/time_step", step.time_step);
  report.set(place + "/faired", step.faired);
  report.set(place + "/length_cross_ratio", step.length_cross_ratio);
  report.set(place + "/trials", step.trials);
  report.set(place + "/gamma", step.spin.eigenvalue);
  report.set(place + "/residual", step.spin.residual);
  report.set(place + "/closure_residual", step.spin.closure_residual);
  report.set(place + "/period_defect", step.period_defect);
  report.set(place + "/remaining_share", step.remaining_share);
  report.set(place + "/direction_norm", step.direction_norm);
  report_distribution(step.spin.conformality.quasi_conformal, place + "/quasi_conformal/step",
                      report);
  report_distribution(step.quasi_conformal, place + "/quasi_conformal/total", report);
  report.set(place + "/seconds", step.seconds);
}

Grid step_grid(const CGP::Flow_report& report)
{
  Grid grid({"step", "energy/4pi", "time step", "trials", "gamma", "closure", "period defect",
             "Q of step", "Q total", "seconds"});
  for (const CGP::Flow_step_report& s : report.steps)
    grid.add({std::to_string(s.step), text_of(s.energy_of_faces / energy_of_sphere),
              text_of(s.time_step, 3), std::to_string(s.trials), text_of(s.spin.eigenvalue, 3),
              text_of(s.spin.closure_residual, 3), text_of(s.period_defect, 3),
              text_of(s.spin.conformality.quasi_conformal.mean, 5),
              text_of(s.quasi_conformal.mean, 5), text_of(s.seconds, 3)});
  return grid;
}

std::string from_to(double before, double after)
{
  return text_of(before / energy_of_sphere) + " to " + text_of(after / energy_of_sphere);
}

/// The mean curvature at the vertices inside, its mean and standard deviation over their areas: how
/// near a surface with boundary is to constant mean curvature. Where binormals are kept, also what
/// of it is not due to the conditions that close the surface: the flow is stationary without it.
void tell_mean_curvature(const CGP::Mesh_view& mesh, double direction_norm, Report& report)
{
  Eigen::VectorXd weights = CGP::vertex_areas(mesh);
  const double unexplained = direction_norm / std::sqrt(weights.sum());
  for (const auto& loop : CGP::boundary_loops(mesh))
    for (const int v : loop) weights[v] = 0;
  if (!(weights.sum() > 0)) return;
  weights /= weights.sum();
  const Eigen::VectorXd H = CGP::mean_curvature(mesh);
  const double mean = weights.dot(H);
  const double deviation = std::sqrt(weights.dot((H.array() - mean).square().matrix()));
  report.set("result/mean_curvature/mean", mean);
  report.set("result/mean_curvature/deviation", deviation);
  report.show("mean curvature (1/length), deviation",
              text_of(mean, 4) + ", " + text_of(deviation, 3));
  if (direction_norm > 0)
    report.tell("result/mean_curvature/not_closing", "of it, what does not close the surface",
                unexplained, 3);
}

void tell_enclosure(const CGP::Flow_report& flow, Report& report)
{
  const CGP::Enclosure &before = flow.initial_enclosure, &after = flow.enclosure;
  report.set("result/area/initial", before.area);
  report.set("result/area/final", after.area);
  report.set("result/volume/initial", before.volume);
  report.set("result/volume/final", after.volume);
  report.set("result/reduced_volume/initial", before.reduced_volume);
  report.set("result/reduced_volume/final", after.reduced_volume);
  report.show("reduced volume",
              text_of(before.reduced_volume) + " to " + text_of(after.reduced_volume));
}

void tell_shape(const Flow_solution& solution, const CGP::Mesh_view& initial, Report& report)
{
  const CGP::Flow_report& flow = solution.report;
  report.set("result/energy/initial", flow.initial_energy_of_faces);
  report.set("result/energy/final", flow.energy_of_faces);
  report.show("energy / 4 pi", from_to(flow.initial_energy_of_faces, flow.energy_of_faces));
  const CGP::Mesh_view last(solution.positions, initial.corners());
  const auto topology = CGP::topology(initial);
  if (topology.is_closed()) tell_enclosure(flow, report);
  if (!topology.is_closed()) tell_mean_curvature(last, flow.direction_norm, report);
  if (!topology.is_sphere()) return;
  const Radius r = radius(last);
  report.set("result/radius/mean", r.mean);
  report.tell("result/radius/deviation", "radius, deviation / mean", r.deviation);
}

/// what the flow has measured on the triangulation that it uses, where that is another
void tell_triangulation(const CGP::Flow_report& flow, Report& report)
{
  const CGP::Conformality &map = flow.conformality, &of_faces = flow.conformality_of_faces;
  const bool is_same = flow.energy == flow.energy_of_faces &&
                       map.length_cross_ratio.max == of_faces.length_cross_ratio.max;
  if (is_same) return;
  const std::string place = "result/triangulation";
  report.set(place + "/energy/initial", flow.initial_energy);
  report.set(place + "/energy/final", flow.energy);
  report_distribution(map.quasi_conformal, place + "/quasi_conformal", report);
  report.set(place + "/length_cross_ratio/rms", map.length_cross_ratio.rms);
  report.set(place + "/length_cross_ratio/max", map.length_cross_ratio.max);
  report.set(place + "/flipped_faces", map.flipped_faces);
  report.show("on the intrinsic Delaunay triangulation",
              "energy / 4 pi " + from_to(flow.initial_energy, flow.energy) + ", Q " +
                  text_of(map.quasi_conformal.mean, 5) + ", largest " +
                  text_of(map.quasi_conformal.max, 4) + ", " +
                  count_of(static_cast<std::size_t>(map.flipped_faces), "flip"));
}

void tell_class(const CGP::Flow_report& flow, const CGP::Mesh_view& initial, Report& report)
{
  tell_triangulation(flow, report);
  if (CGP::topology(initial).genus > 0)
    report.tell("result/conformal_type_change", "change of conformal type",
                flow.conformal_type_change, 3);
}

void tell_place(const CGP::Flow_step_report::Place& place, Report& report)
{
  if (place.vertex < 0) return;
  report.set("result/stop_place/vertex", place.vertex);
  report.set("result/stop_place/face", place.face);
  report.set("result/stop_place/angle_degrees", place.angle * 180 / std::acos(-1.));
}

}  // namespace

std::string reason(const CGP::Flow_report& report)
{
  if (report.stop == CGP::Flow_step_report::Stop::cancelled) return "interrupted";
  const CGP::Enclosure& last = report.enclosure;
  std::string words = CGP::to_string(report.stop);
  if (!report.has_volume())
    words = "the reduced volume is " + text_of(last.reduced_volume) + ", not yet " +
            text_of(last.reduced_volume * std::exp(report.missing_volume)) + ", and " + words;
  if (report.message.empty()) return words;
  return words + " (" + report.message + CGP::to_string(report.place) + ")";
}

void tell_flow(const Flow_solution& solution, const CGP::Mesh_view& initial,
               const CGP::Spin_report& evidence, Outcome& outcome)
{
  const CGP::Flow_report& flow = solution.report;
  Report& report = outcome.report;
  report.show(step_grid(flow));
  report.tell("result/steps", "steps", static_cast<int>(flow.steps.size()));
  report.set("result/stop", reason(flow).c_str());
  report.show("stopped because", reason(flow));
  tell_place(flow.place, report);
  report.set("result/converged", flow.converged());
  tell_shape(solution, initial, report);
  report.set("result/residual", evidence.residual);
  report.set("result/iterations", evidence.iterations);
  report.tell("result/closure_residual", "closure residual, worst", evidence.closure_residual, 3);
  report.set("result/period_defect", flow.period_defect);
  tell_conformality(flow.conformality_of_faces, measured_faces(evidence, initial.size_of_faces()),
                    report);
  if (flow.scales.bound > 0) {
    tell_scales(flow.scales, report);
    report.tell("result/scale_control/steps", "steps kept to the bound on lengths",
                flow.bounded_steps);
  }
  tell_class(flow, initial, report);
  tell_mollification(evidence.mollification, report);
  report.set("steps", Report::Value(std::vector<double>()));
  for (std::size_t i = 0; i < flow.steps.size(); ++i)
    report_step(flow.steps[i], "steps/" + std::to_string(i), report);
  add_seconds(evidence, outcome.seconds);
}

}  // namespace conformal
