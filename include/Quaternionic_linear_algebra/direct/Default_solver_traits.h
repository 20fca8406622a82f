// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief The default solvers of all algorithms: the library's own, which depend on Eigen only and
/// are the fastest on every mesh measured (doc/performance.md).
using Default_solver_traits = Supernodal_solver_traits;

}  // namespace Conformal_geometry_processing
