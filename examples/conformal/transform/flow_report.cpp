// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "flow_report.h"

#include "conformal/process/text.h"
#include "conformal/report/certificate.h"

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

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
  report.set(place + "/energy", step.energy);
  report.set(place + "/time_step", step.time_step);
  report.set(place + "/faired", step.faired);
  report.set(place + "/length_cross_ratio", step.length_cross_ratio);
  report.set(place + "/trials", step.trials);
  report.set(place + "/gamma", step.spin.eigenvalue);
  report.set(place + "/residual", step.spin.residual);
  report.set(place + "/closure_residual", step.spin.closure_residual);
  report.set(place + "/period_defect", step.period_defect);
  report.set(place + "/remaining_share", step.remaining_share);
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
    grid.add({std::to_string(s.step), text_of(s.energy / energy_of_sphere), text_of(s.time_step, 3),
              std::to_string(s.trials), text_of(s.spin.eigenvalue, 3),
              text_of(s.spin.closure_residual, 3), text_of(s.period_defect, 3),
              text_of(s.spin.conformality.quasi_conformal.mean, 5),
              text_of(s.quasi_conformal.mean, 5), text_of(s.seconds, 3)});
  return grid;
}

void tell_shape(const Flow_solution& solution, const CGP::Mesh_view& initial, Report& report)
{
  const CGP::Flow_report& flow = solution.report;
  report.set("result/energy/initial", flow.initial_energy);
  report.set("result/energy/final", flow.energy);
  report.show("energy / 4 pi", text_of(flow.initial_energy / energy_of_sphere) + " to " +
                                   text_of(flow.energy / energy_of_sphere));
  if (!CGP::topology(initial).is_sphere()) return;
  const Radius r = radius({solution.positions, initial.corners()});
  report.set("result/radius/mean", r.mean);
  report.tell("result/radius/deviation", "radius, deviation / mean", r.deviation);
}

void tell_class(const CGP::Flow_report& flow, const CGP::Mesh_view& initial, Report& report)
{
  const CGP::Conformality& faces = flow.conformality_of_faces;
  if (faces.quasi_conformal.max != flow.conformality.quasi_conformal.max) {
    report_distribution(faces.quasi_conformal, "result/faces/quasi_conformal", report);
    report.set("result/faces/flipped_faces", faces.flipped_faces);
    report.show("measured on", "the intrinsic Delaunay triangulation; on the faces Q is " +
                                   text_of(faces.quasi_conformal.mean, 5) + ", largest " +
                                   text_of(faces.quasi_conformal.max, 4) + ", " +
                                   count_of(static_cast<std::size_t>(faces.flipped_faces), "flip"));
  }
  if (CGP::topology(initial).genus > 0)
    report.tell("result/conformal_type_change", "change of conformal type",
                flow.conformal_type_change, 3);
}

}  // namespace

std::string reason(const CGP::Flow_report& report)
{
  if (report.stop == CGP::Flow_step_report::Stop::cancelled) return "interrupted";
  const std::string words = CGP::to_string(report.stop);
  return report.message.empty() ? words : words + " (" + report.message + ")";
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
  report.set("result/converged", flow.converged());
  tell_shape(solution, initial, report);
  report.set("result/residual", evidence.residual);
  report.set("result/iterations", evidence.iterations);
  report.tell("result/closure_residual", "closure residual, worst", evidence.closure_residual, 3);
  report.set("result/period_defect", flow.period_defect);
  tell_conformality(flow.conformality, measured_faces(evidence, initial.size_of_faces()), report);
  tell_class(flow, initial, report);
  tell_mollification(evidence.mollification, report);
  report.set("steps", Report::Value(std::vector<double>()));
  for (std::size_t i = 0; i < flow.steps.size(); ++i)
    report_step(flow.steps[i], "steps/" + std::to_string(i), report);
  add_seconds(evidence, outcome.seconds);
}

}  // namespace conformal
