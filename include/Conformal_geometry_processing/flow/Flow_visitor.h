// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Flow_report.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Eigensolver_result.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief a model of `FlowVisitor` that does nothing; derive from it to override a function.
///
/// Its exceptions are propagated; the flow then remains at its last complete step.
struct Flow_visitor {
  /// called once, with the initial surface and its energy
  void on_flow_begin(const Mesh_view&, double) {}

  /// called before every iteration of the eigensolver
  void on_iteration(const Eigensolver_progress&) {}

  /// called before every step and after every iteration: false stops the flow at the last complete
  /// step
  bool go_further() { return true; }

  /// called after every accepted step, with the new surface
  void on_step_end(const Flow_step_report&, const Mesh_view&) {}
};

}  // namespace Conformal_geometry_processing
