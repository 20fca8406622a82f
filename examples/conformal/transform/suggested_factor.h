// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "solve_spin.h"

#include "conformal/report/Session.h"

namespace conformal {

/// a factor of rho, and what it has cost to find it
struct Suggestion {
  double factor = 0;
  int solves = 0;
};

/// \brief Finds by bisection a factor below one with which rho of a refused problem has a solution
/// that verifies; the largest one up to a sixteenth where all smaller ones verify. Zero if there is
/// none, also where rho is zero.
///
/// Costs up to four solutions of the problem, and no further one after 1,000 solves.
/// \throws Failure if a signal comes
Suggestion suggested_factor(const CGP::Mesh_view& mesh, const Spin_problem& refused,
                            Session& session);

}  // namespace conformal
