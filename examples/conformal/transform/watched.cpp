// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "watched.h"

#include "conformal/process/Progress.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"

#include <cmath>

namespace conformal {

Spin_solution watched(const std::function<Spin_solution(const Go_further&)>& solve,
                      double tolerance, Session& session, const std::string& words)
{
  const int dear = 250;  // iterations: some ten times those of most results
  int calls = 0;
  Progress progress = session.progress();
  progress.show({"factorization", 0, words + "factorization"});
  const auto go_further = [&](const CGP::Eigensolver_progress& p) {
    if (++calls == dear) {
      progress.clear();
      session.note("this takes long: " + std::to_string(dear) +
                   " iterations, where most results take 20 to 40; a signal (Ctrl-C) ends it");
    }
    progress.show({"iteration", std::log(p.estimate) / std::log(tolerance),
                   words + "iteration " + std::to_string(p.iteration + 1) + ", residual " +
                       text_of(p.estimate, 2),
                   p.iteration + 1});
    return signal_received() == 0;
  };
  Spin_solution solution = solve(go_further);
  throw_if_interrupted();
  if (solution.report.is_unfinished)
    session.note("the search has ended after " + std::to_string(calls) +
                 " iterations with the best surface that it had");
  return solution;
}

}  // namespace conformal
