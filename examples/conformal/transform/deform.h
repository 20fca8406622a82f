// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Spin_options.h"
#include "solve_twice.h"

#include "conformal/input/Surface_input.h"
#include "conformal/report/Session.h"

#include <string>

namespace conformal {

/// Tells the certificate, and what came of the boundary.
void tell_solution(const Surface_input& input, const CGP::Boundary_condition& boundary,
                   const CGP::Spin_report& spin, Outcome& outcome);

/// \brief Concludes on a solution by the limits of its request, and notes where it is one of
/// another problem.
/// \param easier advice for an easier problem
/// \param what the cause, for the message
/// \throws Failure if it does not verify, unless that is forced
void conclude(const CGP::Spin_result& solution, bool is_forced, const std::string& easier,
              Session& session, const std::string& what);

/// \brief Common part of `conformal spin` and `conformal boundary`: solves the problem of a surface
/// in one component, tells the certificate, and concludes. \throws Failure
Spin_solution deform(const Surface_input& input, const Spin_problem& problem,
                     const Spin_options& options, const std::string& easier, Session& session);

}  // namespace conformal
