// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_SOLVE_ROBUSTLY_H
#define CONFORMAL_SOLVE_ROBUSTLY_H

#include "solve_spin.h"

#include <Conformal_geometry_processing/spin/Dirac_solution.h>

namespace conformal {

/// Calls the library's `Robust_closing_spin_transformation`, which takes faces of area zero. This
/// is the one place that compiles it. \pre `problem.mollification` is between 0 and 1
Spin_solution solve_robustly(
    const CGP::Mesh_view& mesh, const Spin_problem& problem, const CGP::Dirac_options& options,
    const std::function<bool(const CGP::Eigensolver_progress&)>& go_further);

}  // namespace conformal

#endif
