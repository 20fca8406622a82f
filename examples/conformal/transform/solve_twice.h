// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "solve_spin.h"

#include "conformal/report/Session.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <string>

namespace conformal {

/// the result of the library
struct Spin_solution : CGP::Spin_result {
  std::string note = {};  ///< changes that were not requested, empty if none
};

/// \brief Runs `solve_spin()` with a progress line. If the result does not verify, the alternative
/// problem is solved, and used and noted if it verifies; otherwise the first result is returned.
/// \param words said before those of progress
/// \throws Failure on a signal, and exceptions of the library in the first attempt
Spin_solution solve_twice(const CGP::Mesh_view& mesh, const Spin_problem& problem, Session& session,
                          const std::string& words = "");

}  // namespace conformal
