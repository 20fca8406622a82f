// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>

#include "Fairing_flow.h"

namespace cgp_benchmark {

/// the flow of this library
class Conformal_willmore : public Fairing_flow {
 public:
  /// \param backtracking whether a step that is too large is tried again with half of tau
  Conformal_willmore(const CGP::Mesh_view& mesh, double time_step, bool backtracking)
      : m_flow(mesh, options(time_step, backtracking))
  {}

  bool step() override
  {
    const CGP::Flow_step_report report = m_flow.step();
    if (report.stop == CGP::Flow_step_report::Stop::step_failed)
      throw CGP::Solver_error("Conformal_willmore_flow", report.message);
    m_stop = report.stop;
    return report.accepted;
  }

  /// why no step should follow the last one, if so
  CGP::Flow_step_report::Stop stop() const { return m_stop; }

  const CGP::Mesh_view& mesh() const override { return m_flow.mesh(); }

  /// area and centroid never change
  void set_positions(CGP::Points) override {}

 private:
  static CGP::Flow_options options(double time_step, bool backtracking)
  {
    CGP::Flow_options options;
    options.time_step = time_step;
    options.backtracking = backtracking;
    options.surface.exact_conformal_class = false;  // one equation against another
    return options;
  }

  CGP::Conformal_willmore_flow m_flow;
  CGP::Flow_step_report::Stop m_stop = CGP::Flow_step_report::Stop::none;
};

}  // namespace cgp_benchmark
