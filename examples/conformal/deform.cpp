// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "deform.h"

#include "Failure.h"
#include "Progress.h"
#include "boundary_report.h"
#include "interruption.h"
#include "io/write_surface.h"
#include "rho.h"
#include "verification.h"
#include "write_result.h"

#include <algorithm>
#include <cmath>

namespace conformal {
namespace {

Spin_solution solve(const CGP::Mesh_view& mesh, const Spin_problem& problem,
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
  Spin_solution solution = solve_spin(mesh, problem, options, common, go_further);
  throw_if_interrupted();
  return solution;
}

void tell(const Surface_input& input, const Spin_problem& problem, const CGP::Spin_report& spin,
          Session& session)
{
  report_certificate(spin, session.report());
  Table table = certificate_table(spin, input.mesh.size_of_faces());
  report_boundary(input.mesh, problem.boundary, spin, session.report());
  add_boundary(input.mesh, problem.boundary, spin, table);
  session.print(table.text());
}

void verify(const Surface_input& input, const Spin_solution& solution, const Spin_options& options,
            const std::string& easier, Session& session)
{
  const std::string fault = objection(solution.report, solution.positions,
                                      input.mesh.size_of_faces(), options.limits, easier);
  session.report().set("verified", fault.empty());
  if (fault.empty() && solution.report.reached < 1)
    session.note("only " + text_of(100 * solution.report.reached, 3) +
                 " % of the way to rho: beyond, the handles and holes do not stay closed");
  if (fault.empty()) return;
  if (!options.force) throw Failure(Exit_code::failed, options.input + ": " + fault);
  session.note("written all the same, as --force says: " + fault);
}

}  // namespace

void deform(const Surface_input& input, Spin_problem problem, const Spin_options& options,
            const std::string& easier, Session& session)
{
  session.end_stage("prepare");
  const CGP::Curvature_potential rho = problem.rho;
  problem.rho.values /= User_frame(input.mesh).unit();
  const Spin_solution solution = solve(input.mesh, problem, options, session.options());
  session.begin_stage();
  tell(input, problem, solution.report, session);
  verify(input, solution, options, easier, session);
  session.note_all(write_surface(session.options().output,
                                 spin_result_file(input, rho, solution, options.lambda)));
  session.end_stage("write");
}

}  // namespace conformal
