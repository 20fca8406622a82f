// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Studio_surface.h"

#include "conformal/input/User_frame.h"
#include "conformal/report/certificate.h"
#include "conformal/report/target_report.h"

#include <Conformal_geometry_processing/measure/distortion.h>

#include <utility>

namespace conformal {
namespace {

CGP::Flow_options single_steps()
{
  CGP::Flow_options options;
  options.max_steps = 1;
  return options;
}

/// an outcome with the verdict on the evidence
Outcome judged(const std::string& command, const Evidence& evidence,
               const CGP::Spin_report::Limits& limits = {})
{
  Outcome outcome;
  outcome.command = command;
  outcome.verdict = judge(evidence, limits, "a weaker rho");
  return outcome;
}

}  // namespace

Studio_surface::Studio_surface(const CGP::Mesh_view& mesh)
    : m_mesh(mesh), m_unit(User_frame(mesh).unit()), m_positions(mesh.positions())
{
  (void)transformation(CGP::internal::default_scale_bound);  // checks the mesh
}

CGP::Spin_transformation& Studio_surface::transformation(double bound)
{
  if (m_transformation && m_bound == bound) return *m_transformation;
  CGP::Spin_transformation_options options;
  if (bound > 1) options.scales.bound = bound;
  m_transformation.emplace(m_mesh, options, "studio");
  m_bound = bound;
  return *m_transformation;
}

CGP::Curvature_potential Studio_surface::in_mesh(const Eigen::VectorXd& rho) const
{
  return CGP::Curvature_potential::on_vertices(rho * (1 / m_unit));
}

void Studio_surface::keep(CGP::Spin_result result)
{
  m_outcome = judged("spin", {result.positions, result.report});
  tell_certificate(result.report, m_mesh.size_of_faces(), m_outcome);
  m_positions = std::move(result.positions);
}

void Studio_surface::preview(const Eigen::VectorXd& rho, double bound, bool continues)
{
  keep(transformation(bound).preview(in_mesh(rho), continues));
}

void Studio_surface::transform(const Eigen::VectorXd& rho, double bound)
{
  keep(transformation(bound).transform(in_mesh(rho)));
}

void Studio_surface::deform(const std::vector<CGP::internal::Control_point>& points, double bound,
                            bool continues)
{
  if (!continues || !m_deformation || m_deformation_bound != bound) {
    CGP::internal::Conformal_deformation_options options;
    if (bound > 1) options.surface.scales.bound = bound;
    m_deformation.emplace(m_mesh, options, "studio");
    m_deformation_bound = bound;
  }
  CGP::Spin_result result = m_deformation->deform(points);
  CGP::Spin_report::Limits limits;
  limits.realised_share = 1;
  const Evidence evidence{
      result.positions, result.report, {}, fault_of_targets(result.report, limits)};
  m_outcome = judged("deform", evidence, limits);
  tell_targets(result.report, points.size(), m_outcome.report);
  tell_certificate(result.report, m_mesh.size_of_faces(), m_outcome);
  m_positions = std::move(result.positions);
}

void Studio_surface::flow()
{
  if (!m_flow) m_flow.emplace(m_mesh, single_steps(), CGP::Willmore_direction(), "studio");
  const CGP::Flow_report flow = m_flow->run();
  if (m_flow_steps == 0) m_flow_energy = flow.initial_energy_of_faces;
  Evidence evidence{m_flow->positions()};
  evidence.map = flow.conformality_of_faces;
  if (flow.steps.empty() && !flow.converged())
    evidence.fault = std::string("no step: ") + CGP::to_string(flow.stop);
  m_outcome = judged("flow", evidence);
  m_flow_steps += static_cast<int>(flow.steps.size());
  m_outcome.report.set("result/steps", m_flow_steps);
  m_outcome.report.set("result/converged", flow.converged());
  m_outcome.report.set("result/energy/initial", m_flow_energy);
  m_outcome.report.set("result/energy/final", flow.energy_of_faces);
  m_outcome.report.set("result/stop", CGP::to_string(flow.stop));
  tell_conformality(flow.conformality_of_faces, m_mesh.size_of_faces(), m_outcome.report);
  m_positions = m_flow->positions();
}

Eigen::VectorXd Studio_surface::quality() const
{
  return CGP::quasi_conformal_errors(m_mesh, m_positions);
}

}  // namespace conformal
