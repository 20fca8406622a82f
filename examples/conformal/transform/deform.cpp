// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "deform.h"

#include "suggested_factor.h"

#include "conformal/process/text.h"
#include "conformal/report/boundary_report.h"
#include "conformal/report/certificate.h"

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <cmath>

namespace conformal {
namespace {

/// \brief Where no conformal surface has prescribed positions, which is not a fault: it gives way.
///
/// With positions that one has, the closure residual is at most a quarter of the edge length by the
/// radius.
void note_what_gives_way(const Surface_input& input, const Spin_solution& solution,
                         Session& session)
{
  if (!solution.report.has_positions || solution.positions.cols() == 0) return;
  const double radius = std::sqrt(CGP::total_area(input.mesh) / std::acos(-1.));
  const double explained = CGP::mean_edge_length(input.mesh) / (3 * radius);
  if (solution.report.closure_residual <= explained) return;
  Eigen::Index face = 0;
  const double most = CGP::quasi_conformal_errors(input.mesh, solution.positions).maxCoeff(&face);
  const std::string vertex = name_of_vertex(input, input.mesh.corners(static_cast<int>(face))[0]);
  session.report().set("result/boundary/gives_way/vertex", vertex.c_str());
  session.report().set("result/boundary/gives_way/quasi_conformal", most);
  session.note(
      "no conformal surface has these positions, or the mesh is too coarse for it: the "
      "surface gives way by " +
      text_of(100 * solution.report.closure_residual, 3) + " % of the edges, most of all at " +
      vertex + ", where the quasi-conformal error is " + text_of(most, 3) +
      "; try: --position-weight 10, or a finer mesh");
}

/// Where a good result is of another problem than that which was posed.
void note_departures(const CGP::Spin_report& report, Session& session)
{
  if (const std::string text = shortfall(report); !text.empty()) session.note(text);
  if (report.reached < 1)
    session.note("only " + text_of(100 * report.reached, 3) +
                 " % of the way to rho: beyond, the handles and holes do not stay closed");
  if (report.missing_share > 0.5)
    session.note(
        text_of(100 * report.missing_share, 3) +
        " % of the norm of rho is left out: with it, the handles and holes would not stay closed");
}

/// what is left out for handles and holes is the same share of a smaller rho, to first order
bool is_in_vain_to_weaken(const CGP::Spin_report& report)
{
  using Fault = CGP::Spin_report::Fault;
  const Fault fault = report.fault();
  return fault == Fault::left_out || fault == Fault::nothing_left;
}

/// \brief advice that names the amplitude with which a refused solution would verify
std::string easier_by_amplitude(const Surface_input& input, const Spin_problem& problem,
                                const Spin_options& options, const Spin_solution& refused,
                                const std::string& easier, Session& session)
{
  if (options.force || problem.minimal || is_in_vain_to_weaken(refused.report) ||
      objection(refused.report, refused.positions, refused.report.limits, "").empty())
    return easier;
  const int dear = 400;  // solves: ten times those of most results
  if (refused.report.solves > dear)
    session.note("no result that verifies after " + std::to_string(refused.report.solves) +
                 " solves; looking for an amplitude that does (--force leaves that out)");
  const Suggestion found = suggested_factor(input.mesh, problem, session);
  session.report().set("result/suggestion_solves", found.solves);
  if (found.factor == 0) return easier;
  const double amplitude = options.rho.amplitude * found.factor;
  session.report().set("result/suggested_amplitude", amplitude);
  return "--amplitude " + text_of(amplitude) + ", with which it verifies, or " + easier;
}

}  // namespace

void tell_solution(const Surface_input& input, const CGP::Boundary_condition& boundary,
                   const CGP::Spin_report& spin, Outcome& outcome)
{
  tell_certificate(spin, input.mesh.size_of_faces(), outcome);
  tell_boundary(input.mesh, boundary, spin, outcome.report);
}

void conclude(const CGP::Spin_result& solution, bool is_forced, const std::string& easier,
              Session& session, const std::string& what)
{
  const Evidence evidence{solution.positions, solution.report};
  const Verdict verdict = judge(evidence, solution.report.limits, easier);
  const bool has_surface = solution.positions.cols() > 0;  // else there is nothing to write
  session.conclude(verdict, on_fault(is_forced && has_surface), what);
  if (verdict.is_verified()) note_departures(solution.report, session);
}

Spin_solution deform(const Surface_input& input, const Spin_problem& problem,
                     const Spin_options& options, const std::string& easier, Session& session)
{
  Spin_solution solution = solve_twice(input.mesh, problem, session);
  session.begin_stage();
  tell_solution(input, problem.request.boundary, solution.report, session.outcome());
  note_what_gives_way(input, solution, session);
  if (!solution.note.empty()) session.note(solution.note);
  conclude(solution, options.force,
           easier_by_amplitude(input, problem, options, solution, easier, session), session,
           session.input());
  return solution;
}

}  // namespace conformal
