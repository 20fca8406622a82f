// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "solve_spin.h"

#include "conformal/report/Session.h"

#include <functional>
#include <string>

namespace conformal {

/// \brief Solves under a line of progress, unless a signal comes. Notes, once, that the search
/// takes long, and that it has ended before it was done.
/// \param tolerance of the search, for its share that is done
/// \param words said before those of progress
/// \throws Failure if one has come, and what `solve` throws
Spin_solution watched(const std::function<Spin_solution(const Go_further&)>& solve,
                      double tolerance, Session& session, const std::string& words = "");

}  // namespace conformal
