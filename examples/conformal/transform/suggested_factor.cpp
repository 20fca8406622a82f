// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "suggested_factor.h"

#include "solve_twice.h"

#include "conformal/report/verification.h"

#include <Quaternionic_linear_algebra/exceptions.h>

namespace conformal {
namespace {

bool has_solution(const CGP::Mesh_view& mesh, const Spin_problem& problem,
                  const Verification_limits& limits, const Session& session)
{
  try {
    const Spin_solution solution = solve_twice(mesh, problem, limits, session);
    return objection(solution.report, solution.positions, limits, "").empty();
  } catch (const CGP::Solver_error& error) {
    if (CGP::is_out_of_memory(error)) throw;
    return false;
  }
}

}  // namespace

double suggested_factor(const CGP::Mesh_view& mesh, const Spin_problem& refused,
                        const Verification_limits& limits, const Session& session)
{
  if (refused.rho.values.isZero(0)) return 0;
  double works = 0, fails = 1;
  for (int k = 0; k < 4; ++k) {
    const double factor = (works + fails) / 2;
    Spin_problem weaker = refused;
    weaker.rho.values *= factor;
    (has_solution(mesh, weaker, limits, session) ? works : fails) = factor;
  }
  return works;
}

}  // namespace conformal
