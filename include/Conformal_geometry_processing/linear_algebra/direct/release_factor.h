// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_RELEASE_FACTOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_RELEASE_FACTOR_H

#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

template <class Solver, class = void>
constexpr bool can_release = false;

template <class Solver>
constexpr bool can_release<Solver, std::void_t<decltype(std::declval<Solver&>().release())>> = true;

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Releases the memory of the solver's factor, if the solver has a member `release()`; its
/// analysis stays.
template <class Solver>
void release_factor(Solver& solver)
{
  if constexpr (internal::can_release<Solver>) solver.release();
}

}  // namespace Conformal_geometry_processing

#endif
