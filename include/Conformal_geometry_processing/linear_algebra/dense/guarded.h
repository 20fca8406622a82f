// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_GUARDED_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_GUARDED_H

#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>

#include <new>

namespace Conformal_geometry_processing::internal {

// Returns the result of `action`, or `out_of_memory` if it throws std::bad_alloc: solvers report
// failure by their status only.
template <class Action>
Solver_status guarded(const Action& action)
{
  try {
    return action();
  } catch (const std::bad_alloc&) {
    return Solver_status::out_of_memory;
  }
}

}  // namespace Conformal_geometry_processing::internal

#endif
