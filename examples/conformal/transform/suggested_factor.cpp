// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "suggested_factor.h"

#include "solve_twice.h"

#include "conformal/process/text.h"
#include "conformal/report/verification.h"

#include <Quaternionic_linear_algebra/exceptions.h>

#include <string>

namespace conformal {
namespace {

bool has_solution(const CGP::Mesh_view& mesh, const Spin_problem& problem, Session& session,
                  const std::string& words, int& solves)
{
  try {
    const Spin_solution solution = solve_twice(mesh, problem, session, words);
    solves += solution.report.solves;
    return objection(solution.report, solution.positions, problem.request.limits, "").empty();
  } catch (const CGP::Solver_error& error) {
    if (CGP::is_out_of_memory(error)) throw;
    return false;
  }
}

}  // namespace

Suggestion suggested_factor(const CGP::Mesh_view& mesh, const Spin_problem& refused,
                            Session& session)
{
  const int most_tries = 4, most_solves = 1000;
  Suggestion found;
  if (refused.rho.values.isZero(0)) return found;
  double fails = 1;
  for (int k = 0; k < most_tries && found.solves < most_solves; ++k) {
    const double factor = (found.factor + fails) / 2;
    Spin_problem weaker = refused;
    weaker.rho.values *= factor;
    const std::string words = "rho times " + text_of(factor) + ", ";
    const bool works = has_solution(mesh, weaker, session, words, found.solves);
    (works ? found.factor : fails) = factor;
  }
  return found;
}

}  // namespace conformal
