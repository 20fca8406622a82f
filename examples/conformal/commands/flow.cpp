// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "flow.h"

#include "conformal/input/boundary_condition.h"
#include "conformal/io/write_surface.h"
#include "conformal/process/Failure.h"
#include "conformal/report/boundary_report.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/report/verification.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/flow_report.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/mesh/topology.h>

#include <optional>

namespace conformal {
namespace {

void require_options_that_fit(const Surface_input& input, const Flow_options& options)
{
  require_boundary_to_keep(input, options.boundary);
  if (options.balance == Balance_choice::none) return;
  const auto topology = CGP::topology(input.mesh);
  if (!topology.is_closed())
    throw unsuitable(options.input, "--balance wants a closed surface; try: without it");
  if (options.balance == Balance_choice::canonical && topology.genus == 0)
    throw unsuitable(options.input,
                     "has genus 0 and so no canonical metric; try: --balance initial");
}

std::string stopped_after(const CGP::Flow_report& report, const Flow_options& options)
{
  return "stopped after " + std::to_string(report.steps.size()) + " of " +
         count_of(static_cast<std::size_t>(options.steps), "step") + ": " + reason(report);
}

/// Describes a fault of the result, or returns an empty text.
std::string fault_of(const Flow_solution& solution, CGP::Spin_report evidence,
                     const Surface_input& input, const Flow_options& options)
{
  const CGP::Flow_report& report = solution.report;
  if (report.steps.empty())
    return report ? ""
                  : stopped_after(report, options) + "; try: a finer mesh, or one without slivers";
  evidence.conformality = report.conformality;
  return objection(evidence, solution.positions, input.mesh.size_of_faces(), options.limits,
                   easier_than_flow);
}

void verify(const Flow_solution& solution, const CGP::Spin_report& evidence,
            const Surface_input& input, const Flow_options& options, Session& session)
{
  const std::string fault = fault_of(solution, evidence, input, options);
  session.report().set("verified", fault.empty());
  if (!fault.empty()) {
    if (!options.force) throw Failure(Exit_code::failed, options.input + ": " + fault);
    session.note("written all the same, as --force says: " + fault);
  } else if (!solution.report && signal_received() == 0) {
    session.note(stopped_after(solution.report, options));
  }
}

void tell(const Flow_solution& solution, const CGP::Spin_report& evidence,
          const Surface_input& input, const Flow_options& options, Session& session)
{
  report_flow(solution, input.mesh, evidence, session.report());
  Table table = flow_table(solution, input.mesh, evidence);
  if (!solution.report.steps.empty()) {
    const CGP::Boundary_condition condition = kept_boundary(options.boundary);
    const CGP::Spin_report& last = solution.report.steps.back().spin;
    report_boundary(input.mesh, condition, last, session.report());
    add_boundary(input.mesh, condition, last, table);
  }
  session.print(step_grid(solution.report).text() + "\n" + table.text());
}

void write(const Flow_solution& solution, const Surface_input& input, Session& session)
{
  Surface_file file = moved(input, solution.positions);
  set_quality(input, solution.positions, file);
  session.note_all(write_surface(session.options().output, file));
  session.end_stage("write");
}

void tell_if_interrupted(const Flow_solution& solution, Session& session)
{
  if (signal_received() == 0) return;
  session.keep_report();
  throw_if_interrupted("the surface after " + count_of(solution.report.steps.size(), "step") +
                       " was written to " + session.options().output);
}

/// Runs the flow on a surface with one component, reports the result, and verifies it.
Flow_solution flowed(const Surface_input& input, const Flow_options& options, Session& session)
{
  require_options_that_fit(input, options);
  session.end_stage("prepare");
  Flow_watch watch(input, options, session);
  Flow_solution solution = run_flow(input.mesh, options, session.options(), watch);
  watch.end();
  if (solution.report.steps.empty()) throw_if_interrupted();
  session.end_stage("flow");
  tell(solution, watch.evidence(), input, options, session);
  verify(solution, watch.evidence(), input, options, session);
  return solution;
}

/// Likewise for each component; the steps are reported for each of them.
Flow_solution flowed_components(const Surface_input& input, const Flow_options& options,
                                Session& session)
{
  if (options.every > 0)
    throw Failure(Exit_code::usage,
                  "--every wants snapshots of the whole surface, whose components flow one after "
                  "the other; try: without --each-component");
  session.end_stage("prepare");
  const auto work = [&](const Component& component, Session& own) {
    Flow_solution solution = flowed(component.input, options, own);
    throw_if_interrupted();
    return std::move(solution.positions);
  };
  return {each_component(input, session, work), {}};
}

}  // namespace

void flow(const Flow_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input =
      read_suitable_surface(options.input, session, flat_faces(options.mollification));
  const Flow_solution solution = session.options().each_component
                                     ? flowed_components(input, options, session)
                                     : flowed(input, options, session);
  keep_exhibit(input, solution.positions, session);
  write(solution, input, session);
  if (!session.options().each_component) tell_if_interrupted(solution, session);
}

}  // namespace conformal
