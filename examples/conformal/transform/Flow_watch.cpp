// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Flow_watch.h"

#include "write_result.h"

#include "conformal/io/file/snapshot_path.h"
#include "conformal/process/text.h"
#include "conformal/report/verification.h"

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace conformal {

Flow_watch::Flow_watch(const Surface_input& input, const Flow_options& options, Session& session)
    : m_input(input), m_options(options), m_session(session), m_progress(session.progress())
{
  m_evidence.steps = 0;
  m_progress.show({"analysis", 0});
}

void Flow_watch::on_flow_begin(const CGP::Mesh_view&, double energy)
{
  m_energy = energy;
  show(0, "");
}

void Flow_watch::on_iteration(const CGP::Eigensolver_progress& progress)
{
  show(std::log(progress.estimate) / std::log(m_options.request.surface.dirac.tolerance),
       ", iteration " + std::to_string(progress.iteration));
}

void Flow_watch::on_step_end(const CGP::Flow_step_report& step, const CGP::Mesh_view& mesh)
{
  if (!m_patience) m_patience.emplace();
  m_energy = step.energy_of_faces;
  m_steps = step.step;
  if (step.time_step > 0)  // otherwise the surface was smoothed only
    append(m_evidence, step.spin);
  else
    m_evidence.mollification = step.spin.mollification;
  m_evidence.direction_error = step.spin.direction_error;
  const int dear = 60;  // steps: some 200 scalar Poisson problems
  if (m_steps == dear) {
    m_progress.clear();
    m_session.note(
        "this takes long: 60 steps, where most surfaces settle in 5 to 20; a signal (Ctrl-C) "
        "ends it, and the surface so far is written");
  }
  if (m_options.every > 0 && step.step % m_options.every == 0) write_snapshot(step.step, mesh);
  show(0, "");
}

void Flow_watch::show(double share_of_step, const std::string& more)
{
  const double share = std::isfinite(share_of_step) ? std::clamp(share_of_step, 0., 1.) : 0;
  const int step = std::min(m_steps + 1, m_options.request.max_steps);
  m_progress.show({"step", (m_steps + share) / m_options.request.max_steps,
                   "step " + std::to_string(step) + " of " +
                       std::to_string(m_options.request.max_steps) + ", energy " +
                       text_of(m_energy / (4 * std::acos(-1.)), 4) + " * 4 pi" + more,
                   step});
}

void Flow_watch::write_snapshot(int step, const CGP::Mesh_view& mesh)
{
  const std::string path = snapshot_path(m_session.options().output, step);
  CGP::Spin_report report = m_evidence;
  const CGP::Mesh_view measured = measured_part(m_input.mesh, report.mollification.share > 0);
  report.conformality = CGP::conformality(measured, mesh.positions(),
                                          CGP::neighbourhood_normals(measured, mesh.positions()));
  const Verdict verdict =
      judge({mesh.positions(), report}, m_options.request.surface.limits, easier_than_flow);
  m_progress.clear();
  std::error_code ignored;
  if (std::filesystem::equivalent(path, m_options.input, ignored))
    return m_session.note(path + " is not written: it is the input");
  if (!verdict.is_verified() && !m_options.force)
    return m_session.note(path + " is not written: " + verdict.fault);
  write_surface(path, result_file(m_input, {mesh.positions()}), ply_style(m_session.options()));
}

}  // namespace conformal
