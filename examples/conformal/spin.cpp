// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "spin.h"

#include "Failure.h"
#include "Progress.h"
#include "closed_surface.h"
#include "interruption.h"
#include "io/write_surface.h"
#include "rho.h"
#include "solve_spin.h"
#include "verification.h"
#include "write_result.h"

#include <algorithm>
#include <cmath>

namespace conformal {
namespace {

Spin_solution solve(const Surface_input& input, const CGP::Curvature_potential& rho,
                    const Spin_options& options, const Common_options& common)
{
  Progress progress(common.quiet);
  progress.show("factorization", 0);
  const auto go_further = [&](const CGP::Eigen_progress& p) {
    progress.show(
        "iteration " + std::to_string(p.iteration) + ", residual " + text_of(p.estimate, 2),
        std::log(p.estimate) / std::log(common.tolerance));
    return signal_received() == 0;
  };
  const double unit = User_frame(input.mesh).unit();
  Spin_solution solution =
      solve_spin(input.mesh, {rho.on, rho.values / unit}, options, common, go_further);
  throw_if_interrupted();
  return solution;
}

void verify(const Surface_input& input, const Spin_solution& solution, const Spin_options& options,
            Session& session)
{
  const std::string fault =
      objection(solution.report, solution.positions, input.mesh.size_of_faces(), options.limits);
  session.report().set("verified", fault.empty());
  if (fault.empty() && solution.report.reached < 1)
    session.note("only " + text_of(100 * solution.report.reached, 3) +
                 " % of the way to rho: beyond, the handles do not stay closed");
  if (fault.empty()) return;
  if (!options.force) throw Failure(Exit_code::failed, options.input + ": " + fault);
  session.note("written all the same, as --force says: " + fault);
}

}  // namespace

void spin(const Spin_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input = read_closed_surface(options.input, session);
  const CGP::Curvature_potential rho = read_rho(input, options.rho);
  if (options.generalized && rho.on == CGP::Curvature_potential::On::vertices)
    throw Failure(Exit_code::usage, "--problem generalized wants rho on faces; try: --on faces");
  session.end_stage("prepare");
  const Spin_solution solution = solve(input, rho, options, session.options());
  session.begin_stage();
  report_certificate(solution.report, session.report());
  session.print(certificate_table(solution.report, input.mesh.size_of_faces()).text());
  verify(input, solution, options, session);
  session.note_all(write_surface(session.options().output,
                                 spin_result_file(input, rho, solution, options.lambda)));
  session.end_stage("write");
}

}  // namespace conformal
