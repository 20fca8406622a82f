// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Flow_options.h"

#include "conformal/input/Surface_input.h"
#include "conformal/process/Progress.h"
#include "conformal/process/interruption.h"
#include "conformal/report/Session.h"

#include <Conformal_geometry_processing/flow/Flow_report.h>

#include <optional>
#include <string>

namespace conformal {

/// what to try where a flow does not verify
inline constexpr const char* easier_than_flow = "a smaller --time-step, fewer --steps";

/// \brief Observes a flow: shows its progress, writes snapshots, stops it on a signal, and
/// accumulates the reports of its steps. After the first complete step, a signal no longer
/// terminates the program, because there is a result to write.
class Flow_watch : public CGP::Flow_visitor {
 public:
  Flow_watch(const Surface_input& input, const Flow_options& options, Session& session);

  void on_flow_begin(const CGP::Mesh_view& mesh, double energy);
  void on_iteration(const CGP::Eigensolver_progress& progress);
  bool go_further() { return signal_received() == 0; }
  void on_step_end(const CGP::Flow_step_report& step, const CGP::Mesh_view& mesh);

  /// The flow is over: the line of progress goes away.
  void end() { m_progress.clear(); }

  /// Of all steps so far: sums of costs, and the worst quality measures
  const CGP::Spin_report& evidence() const { return m_evidence; }

 private:
  void show(double share_of_step, const std::string& more);
  void write_snapshot(int step, const CGP::Mesh_view& mesh);

  const Surface_input& m_input;
  const Flow_options& m_options;
  Session& m_session;
  Progress m_progress;
  CGP::Spin_report m_evidence;
  double m_energy = 0;
  int m_steps = 0;
  std::optional<Patience> m_patience;
};

}  // namespace conformal
