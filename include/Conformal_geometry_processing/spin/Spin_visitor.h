// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_VISITOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_VISITOR_H

#include <Conformal_geometry_processing/linear_algebra/krylov/Eigensolver_result.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief a model of `SpinVisitor` that watches without a word; derive from it to override one.
///
/// Passed by `parameters::visitor(std::ref(v))`. Whatever it throws passes through, and leaves the
/// mesh as it was.
struct Spin_visitor {
  /// called after every iteration of the eigensolver
  void on_iteration(const Eigensolver_progress&) {}

  /// asked then: false stops the work, and nothing is written
  bool go_further() { return true; }
};

}  // namespace Conformal_geometry_processing

#endif
