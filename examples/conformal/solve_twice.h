// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_SOLVE_TWICE_H
#define CONFORMAL_SOLVE_TWICE_H

#include "solve_spin.h"

#include <string>

namespace conformal {

/// \brief `solve_spin()` under a line of progress. Where the result does not verify, the second try
/// of the problem is made, and taken and noted if that verifies; else the first is the result.
/// \param part said before the words of progress
/// \throws Failure if a signal comes, and what the library throws at the first try
Spin_solution solve_twice(const CGP::Mesh_view& mesh, const Spin_problem& problem,
                          const Spin_options& options, const Common_options& common,
                          const std::string& part = "");

}  // namespace conformal

#endif
