// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later

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
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Flow_visitor`}
/// \cgalHasModelsEnd
class FlowVisitor {
 public:
  /// called once, with the surface the flow starts from and its energy
  void on_flow_begin(const Conformal_geometry_processing::Mesh_view& mesh, double energy);

  /// called before every iteration of the eigenvalue solver, as in `SpinVisitor`
  void on_iteration(const Conformal_geometry_processing::Eigensolver_progress& progress);

  /// asked before every step, and after each call of `on_iteration()`: `false` stops the flow at
  /// the last complete step
  bool go_further();

  /// called after every accepted step, with the new surface, whose vertices are numbered in the
  /// order of `vertices(mesh)`
  void on_step_end(const Conformal_geometry_processing::Flow_step_report& report,
                   const Conformal_geometry_processing::Mesh_view& mesh);
};
