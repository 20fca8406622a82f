// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief watches a flow while it runs, and may stop it.
///
/// All functions are called in the thread of the caller. What they throw passes through; a
/// `Conformal_willmore_flow` is at its last complete step then, and `conformal_willmore_flow()` has
/// written nothing. A model need be neither copied nor moved: it is passed as
/// `parameters::visitor(std::ref(v))`. It must not make the flow that it watches go on: that throws
/// `Precondition_error`, and leaves the flow as it was.
///
/// Headers of these types:
/// - `Conformal_geometry_processing::Conformal_willmore_flow`,
///   `Conformal_geometry_processing/flow/Conformal_willmore_flow.h`
/// - `Conformal_geometry_processing::Eigensolver_progress`,
///   `Quaternionic_linear_algebra/krylov/Eigensolver_result.h`
/// - `Conformal_geometry_processing::Flow_step_report`,
///   `Conformal_geometry_processing/flow/Flow_report.h`
/// - `Conformal_geometry_processing::Mesh_view`,
///   `Conformal_geometry_processing/mesh/Mesh_view.h`
/// - `Conformal_geometry_processing::Precondition_error`,
///   `Quaternionic_linear_algebra/exceptions.h`
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Flow_visitor`}
/// \cgalHasModelsEnd
class FlowVisitor {
 public:
  /// called once, with the surface the flow starts from and its energy
  void on_flow_begin(const Mesh_view& mesh, double energy);

  /// called before every iteration of the eigenvalue solver, as in `SpinVisitor`
  void on_iteration(const Eigensolver_progress& progress);

  /// asked before every step, and after each call of `on_iteration()`: `false` stops the flow at
  /// the last complete step
  bool go_further();

  /// called after every accepted step, with the new surface, whose vertices are numbered in the
  /// order of `vertices(mesh)`
  void on_step_end(const Flow_step_report& report, const Mesh_view& mesh);
};
