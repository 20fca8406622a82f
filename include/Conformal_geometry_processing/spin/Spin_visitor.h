// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/krylov/Eigensolver_result.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief a model of `SpinVisitor` that does nothing; derive from it to override a function.
///
/// Pass it by `parameters::visitor(std::ref(v))`. Its exceptions are propagated and leave the mesh
/// unchanged.
struct Spin_visitor {
  /// called after every iteration of the eigensolver
  void on_iteration(const Eigensolver_progress&) {}

  /// called after every iteration: false cancels, and nothing is written
  bool go_further() { return true; }
};

}  // namespace Conformal_geometry_processing
