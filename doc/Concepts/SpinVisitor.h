// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief watches a spin transformation while it runs, and may cancel it.
///
/// Both functions are called in the thread of the caller. What they throw passes through
/// `spin_transform()`, which has written nothing by then. A model need be neither copied nor moved:
/// it is passed as `parameters::visitor(std::ref(v))`. It must not call the object that it watches:
/// that throws `Precondition_error`, and leaves the object as it was.
///
/// Headers of these types:
/// - `Conformal_geometry_processing::Eigensolver_progress`,
///   `Quaternionic_linear_algebra/krylov/Eigensolver_result.h`
/// - `Conformal_geometry_processing::Precondition_error`,
///   `Quaternionic_linear_algebra/exceptions.h`
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Spin_visitor`}
/// \cgalHasModelsEnd
class SpinVisitor {
 public:
  /// called before every iteration of the eigenvalue solver, with the number of iterations done in
  /// this solve (it starts at zero again in every substep), the smallest eigenvalue so far, and the
  /// error estimate, which falls to the tolerance
  void on_iteration(const Eigensolver_progress& progress);

  /// asked after each call of `on_iteration()`: `false` cancels the work
  bool go_further();
};
