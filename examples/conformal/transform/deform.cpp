// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "deform.h"

#include "solve_twice.h"
#include "write_result.h"

#include "conformal/input/rho.h"
#include "conformal/io/write_surface.h"
#include "conformal/process/Failure.h"
#include "conformal/process/Progress.h"
#include "conformal/process/interruption.h"
#include "conformal/report/boundary_report.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/report/verification.h"

#include <algorithm>
#include <cmath>

namespace conformal {

Spin_solution watched(const std::function<Spin_solution(const Go_further&)>& solve,
                      const Common_options& common, const std::string& part)
{
  Progress progress(common.quiet);
  progress.show(part + "factorization", 0);
  const auto go_further = [&](const CGP::Eigensolver_progress& p) {
    progress.show(
        part + "iteration " + std::to_string(p.iteration) + ", residual " + text_of(p.estimate, 2),
        std::log(p.estimate) / std::log(common.tolerance));
    return signal_received() == 0;
  };
  Spin_solution solution = solve(go_further);
  throw_if_interrupted();
  return solution;
}

void tell_certificate(const Surface_input& input, const Deformation& deformation, Session& session)
{
  const CGP::Spin_report& spin = deformation.solution.report;
  report_certificate(spin, session.report());
  Table table = certificate_table(spin, input.mesh.size_of_faces());
  report_boundary(input.mesh, deformation.boundary, spin, session.report());
  add_boundary(input.mesh, deformation.boundary, spin, table);
  session.print(table.text());
}

namespace {

/// Where a good result is of another problem than that which was posed.
void tell_departures(const Spin_solution& solution, Session& session)
{
  const CGP::Spin_report& report = solution.report;
  if (!solution.note.empty()) session.note(solution.note);
  if (report.reached < 1)
    session.note("only " + text_of(100 * report.reached, 3) +
                 " % of the way to rho: beyond, the handles and holes do not stay closed");
  if (report.missing_share > 0.5)
    session.note(text_of(100 * report.missing_share, 3) +
                 " % of rho is left out: with it, the handles and holes would not stay closed");
}

}  // namespace

void verify(const std::string& what, const Surface_input& input, const Spin_solution& solution,
            const Spin_options& options, const std::string& easier, Session& session)
{
  const std::string fault = objection(solution.report, solution.positions,
                                      input.mesh.size_of_faces(), options.limits, easier);
  session.report().set("verified", fault.empty());
  if (fault.empty()) return tell_departures(solution, session);
  if (!options.force) throw Failure(Exit_code::failed, what + ": " + fault);
  session.note("written all the same, as --force says: " + fault);
}

void write_deformation(const std::string& path, const Surface_input& input,
                       const Deformation& deformation, const std::string& lambda, Session& session)
{
  session.note_all(
      write_surface(path, spin_result_file(input, deformation.rho, deformation.solution, lambda)));
}

void deform(const Surface_input& input, Spin_problem problem, const Spin_options& options,
            const std::string& easier, Session& session)
{
  session.end_stage("prepare");
  Deformation deformation{problem.rho, problem.boundary, {}};
  problem.rho.values /= User_frame(input.mesh).unit();
  deformation.solution = solve_twice(input.mesh, problem, options, session.options());
  session.begin_stage();
  tell_certificate(input, deformation, session);
  verify(options.input, input, deformation.solution, options, easier, session);
  keep_exhibit(input, deformation.solution.positions, session);
  write_deformation(session.options().output, input, deformation, options.lambda, session);
  session.end_stage("write");
}

}  // namespace conformal
