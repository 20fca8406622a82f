// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <new>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Result of an operation of a sparse solver.
enum class Solver_status {
  success,
  not_positive_definite,  ///< a pivot is zero or negative, or too small to invert
  numerical_issue,        ///< an entry of the matrix or of the factor is not finite
  out_of_memory,
  wrong_state  ///< the call does not fit the earlier ones: not analyzed, not factorized, other
               ///< sizes
};

/// \relates Solver_status
/// Describes the status, for messages
constexpr const char* to_string(Solver_status status)
{
  switch (status) {
    case Solver_status::success:
      return "success";
    case Solver_status::not_positive_definite:
      return "the matrix is not positive definite";
    case Solver_status::numerical_issue:
      return "a value is not finite";
    case Solver_status::out_of_memory:
      return "out of memory";
    case Solver_status::wrong_state:
      return "the solver was not prepared for this call";
  }
  return "unknown";
}

/// \ingroup PkgLinearAlgebra
/// \brief Cost of a factorization, known after `analyze()`.
struct Solver_statistics {
  std::int64_t factor_entries = 0;  ///< stored scalars (numbers or quaternions) of the factor
  double flops = 0;                 ///< floating-point operations of one factorization
  double bytes = 0;                 ///< memory of the factor
};

namespace internal {

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

}  // namespace internal
}  // namespace Conformal_geometry_processing
