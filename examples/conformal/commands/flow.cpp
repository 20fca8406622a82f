// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "keyed_options.h"
#include "option_groups.h"

#include "conformal/input/boundary_condition.h"
#include "conformal/input/delaunay_faces.h"
#include "conformal/process/Failure.h"
#include "conformal/process/text.h"
#include "conformal/report/boundary_report.h"
#include "conformal/transform/Flow_watch.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/flow_report.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>

namespace conformal {
namespace {

const char* const flow_about =
    "Smooths a surface by the conformal Willmore flow: as smooth as its conformal class allows, a\n"
    "sphere where there are no handles. With a boundary that is free, or keeps its tangents, it\n"
    "becomes a minimal surface; with its binormals kept, one of constant mean curvature where one\n"
    "closes around its holes. Otherwise it stops where only these conditions keep it from that: "
    "the\n"
    "table has the mean and the deviation, and what of it they do not explain. On the faces of "
    "the\n"
    "file no step leaves the limits; with --connectivity delaunay these are others.\n"
    "Limbs, and what is behind a thin neck, become small, as conformal maps have it, unless\n"
    "--max-scale bounds lengths against the input: the flow then ends with the least energy that\n"
    "this admits.\n"
    "Area, centroid and triangle quality stay. Surfaces stay on their exact discrete conformal\n"
    "class, that of their intrinsic Delaunay triangulation, and are smoothed within it.\n"
    "The output has the vertex property quality (quasi-conformal error against the input, 1 is\n"
    "perfect). The flow stops early where the energy has settled. Where no step lowers it, or the\n"
    "next one would not verify, it writes the surface after the last good step, and the exit code\n"
    "is 1.\n"
    "When interrupted (Ctrl-C, SIGTERM), it writes the surface after the last complete step (with\n"
    "--each-component nothing), and ends with exit code 130 or 143; a second signal ends it at "
    "once.\n"
    "A result that does not verify is not written.\n"
    "Example: conformal flow bear.off -o bear_flow.ply --html bear.html";

const double keep_volume = 0;  // that of the input

void add_reduced_volume(CLI::App& command, std::optional<double>& volume)
{
  const auto read = [&volume](const std::string& text) {
    volume = text == "keep" ? keep_volume : std::strtod(text.c_str(), nullptr);
  };
  const auto is_volume = [](const std::string& text) {
    char* end = nullptr;
    const double v = std::strtod(text.c_str(), &end);
    const bool is_good = text == "keep" || (*end == 0 && v > 0 && v <= 1);
    return is_good ? std::string() : "a number above 0 and up to 1, or keep, is needed: " + text;
  };
  command
      .add_option_function<std::string>(
          "--reduced-volume", read,
          "volume of a closed surface by that of the round sphere of the same area, which the flow "
          "leads to by a twentieth in a step; or keep, that of the input: ends at shapes of "
          "vesicles, as red blood cells are")
      ->check(CLI::Validator(is_volume, "0 < FLOAT <= 1 or keep"))
      ->excludes("--plain");
}

void add_options(CLI::App& command, Flow_options& flow, Common_options& common)
{
  CGP::Spin_transformation_options& surface = flow.request.surface;
  add_input(command, flow.input);
  add_transformation(command, common);
  command.add_option("--steps", flow.request.max_steps, "how many steps at most")
      ->check(above_zero)
      ->capture_default_str();
  command
      .add_option("--time-step", flow.request.time_step,
                  "the largest; 1 goes furthest, 2 is the limit of stability")
      ->check(above_zero)
      ->check(CLI::Range(0., 2.))
      ->capture_default_str();
  command
      .add_option("--filter-weight", flow.request.filter_weight,
                  "keeps the large features; detail finer than this to the power "
                  "1/(2 order), in radii of the sphere of the same area, is smoothed")
      ->check(above_zero);
  advanced(command)
      .add_option("--filter-order", flow.request.filter_order, "sharpness of the filter, 0 to 3")
      ->check(CLI::Range(0, 3))
      ->needs(command.get_option("--filter-weight"))
      ->capture_default_str();
  command.add_flag_callback(
      "--plain", [&surface] { surface.exact_conformal_class = false; },
      "the flow of the thesis: surfaces drift from their conformal class by the error of each "
      "step, and are not smoothed otherwise");
  advanced(command).add_flag_callback(
      "--no-fairing", [&flow] { flow.request.fairing = false; },
      "no smoothing within the conformal class, curvature flow only");
  add_max_scale(command, surface.scales.bound,
                ", against the input: limbs, and what is behind a thin neck, become no smaller");
  add_reduced_volume(command, flow.request.reduced_volume);
  add_boundary(command, surface.boundary);
  add_mollification(command, surface.mollification,
                    "; without --plain no edge becomes longer: vertices of faces that are still "
                    "without area after the flips move by a thousandth of their edges");
  add_period_defect(command, surface.max_period_defect);
  add_choice(command, "--balance", flow.request.balance, {"none", "initial", "canonical"},
             "undoes drift of closed surfaces by sphere inversions: towards the initial areas, "
             "or those of the canonical metric (genus > 0)")
      ->excludes("--reduced-volume");
  add_choice(command, "--connectivity", flow.connectivity, {"keep", "delaunay"},
             "of what is written: that of the file, on whose faces no step leaves the limits, or "
             "with edges flipped until it is Delaunay, on which the flow computes; the table tells "
             "what either comes to");
  command
      .add_option("--every", flow.every,
                  "write every so many steps a snapshot, OUTPUT with the number of the step: "
                  "bear_0005.ply")
      ->check(above_zero);
  add_eigenvector(command, surface.dirac);
  add_limits(command, surface.limits, flow.force);
}

Files files(const Flow_options& flow)
{
  return {{"the input", flow.input, Named_file::Role::replaceable}};
}

void require_options_that_fit(const Surface_input& input, const Flow_options& options)
{
  require_boundary_to_keep(input, options.request.surface.boundary);
  if (options.request.reduced_volume && !CGP::topology(input.mesh).is_closed())
    throw unsuitable(options.input, "--reduced-volume wants a closed surface; try: without it");
  using Balance = CGP::Flow_options::Balance;
  if (options.request.balance == Balance::none) return;
  const auto topology = CGP::topology(input.mesh);
  if (!topology.is_closed())
    throw unsuitable(options.input, "--balance wants a closed surface; try: without it");
  if (options.request.balance == Balance::canonical && topology.genus == 0)
    throw unsuitable(options.input,
                     "has genus 0 and so no canonical metric; try: --balance initial");
}

std::string stopped_after(const CGP::Flow_report& report, const Flow_options& options)
{
  return "stopped after " + std::to_string(report.steps.size()) + " of " +
         count_of(static_cast<std::size_t>(options.request.max_steps), "step") + ": " +
         reason(report);
}

std::string fault_of_type(const CGP::Flow_report& report)
{
  if (report.keeps_conformal_type()) return {};
  const bool is_open = report.conformal_type_change <= CGP::Flow_report::max_conformal_type_change;
  return (is_open
              ? "the edges have failed to close up around handles and holes by " +
                    text_of(report.period_defect, 3) + " in all steps"
              : "the conformal type has changed by " + text_of(report.conformal_type_change, 3)) +
         "; try: without --plain, a smaller --time-step, or a finer mesh";
}

Evidence evidence_of(const Flow_solution& solution, const CGP::Spin_report& steps,
                     const Flow_options& options)
{
  const CGP::Flow_report& report = solution.report;
  Evidence evidence{solution.positions};
  if (steps.steps > 0) {
    evidence.spin = steps;
    evidence.spin->conformality = report.conformality_of_faces;
  } else if (!report.steps.empty()) {
    evidence.map = report.conformality_of_faces;
  } else if (!report) {
    evidence.fault = stopped_after(report, options) + "; try: a finer mesh, or one without slivers";
  }
  if (evidence.fault.empty()) evidence.fault = fault_of_type(report);
  return evidence;
}

/// what to try where a flow was stopped by what it met
std::string easier_than(CGP::Flow_step_report::Stop stop, Connectivity connectivity)
{
  using Stop = CGP::Flow_step_report::Stop;
  const std::string flips =
      connectivity == Connectivity::keep ? "--connectivity delaunay for thin faces, " : "";
  if (stop == Stop::limits_reached) return flips + "fewer --steps, or a larger --limit";
  if (stop == Stop::scale_range) return "fewer --steps";
  if (stop == Stop::steps_done) return "more --steps";
  return "--mollify for thin faces, fewer --steps, or a finer mesh";
}

/// with the numbers of the file
CGP::Flow_step_report::Place in_file(CGP::Flow_step_report::Place place, const Surface_input& input)
{
  if (place.vertex < 0) return place;
  place.vertex = input.vertex_in_file[static_cast<std::size_t>(place.vertex)];
  place.face = input.face_in_file[static_cast<std::size_t>(place.face)];
  return place;
}

/// Conformal maps of long limbs and behind thin necks are exponential: how much has become small.
void note_collapse(const Flow_solution& solution, const Surface_input& input, Session& session)
{
  const double share = solution.report.conformality_of_faces.scale.collapsed_share;
  const double noteworthy = .01;
  if (share <= noteworthy) return;
  Eigen::Index face = 0;
  const double least = CGP::length_scales(input.mesh, solution.positions).minCoeff(&face);
  session.note(text_of(100 * share, 3) +
               " % of the area has shrunk below a tenth, lengths of face " +
               std::to_string(input.face_in_file[static_cast<std::size_t>(face)]) + " to " +
               text_of(least, 2) +
               ": limbs, and what is behind a thin neck, become small; try: fewer --steps, or "
               "--max-scale 4");
}

/// A flow that was stopped by what it met has not done what was asked, though its last surface
/// verifies: that is written, and the run has failed.
void conclude(const Flow_solution& solution, const Surface_input& input,
              const CGP::Spin_report& steps, const Flow_options& options, Session& session)
{
  Verdict verdict = judge(evidence_of(solution, steps, options), options.request.surface.limits,
                          easier_than_flow);
  const bool is_good = verdict.is_verified();
  if (is_good && !solution.report.is_complete() && signal_received() == 0)
    verdict.fault = stopped_after(solution.report, options) +
                    "; the surface after the last of them is written; try: " +
                    easier_than(solution.report.stop, options.connectivity);
  const On_fault write = is_good ? On_fault::fail_in_the_end : On_fault::refuse;
  session.conclude(verdict, options.force ? On_fault::force : write);
  note_collapse(solution, input, session);
}

void tell(const Flow_solution& solution, const CGP::Spin_report& evidence,
          const Surface_input& input, const Flow_options& options, Session& session)
{
  tell_flow(solution, input.mesh, evidence, session.outcome());
  if (!solution.report.steps.empty())
    tell_boundary(input.mesh, options.request.surface.boundary, solution.report.steps.back().spin,
                  session.report());
}

void throw_if_interrupted_after(const CGP::Flow_report& report, Session& session)
{
  if (signal_received() == 0) return;
  session.keep_report();
  throw_if_interrupted("the surface after " + count_of(report.steps.size(), "step") +
                       " was written to " + session.options().output);
}

/// Runs the flow on a surface with one component, tells what came of it, and concludes.
Flow_solution flowed(const Surface_input& input, const Flow_options& options, Session& session)
{
  require_options_that_fit(input, options);
  CGP::Flow_options request = options.request;
  if (options.force) request.surface.limits.map = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  if (request.reduced_volume == keep_volume)
    request.reduced_volume = CGP::enclosure(input.mesh).reduced_volume;
  Flow_watch watch(input, options, session);
  CGP::Conformal_willmore_flow flow(input.mesh, request, {}, "flow");
  Flow_solution solution{{}, flow.run(watch)};
  solution.positions = flow.positions();
  solution.report.place = in_file(solution.report.place, input);
  watch.end();
  if (solution.report.steps.empty()) throw_if_interrupted();
  session.end_stage("flow");
  tell(solution, watch.evidence(), input, options, session);
  conclude(solution, input, watch.evidence(), options, session);
  return solution;
}

void require_no_snapshots(const Flow_options& options)
{
  if (options.every > 0)
    throw Failure(Exit_code::usage,
                  "--every wants snapshots of the whole surface, whose components flow one after "
                  "the other; try: without --each-component");
}

/// Flips edges of the input where that is asked for, and tells which faces are others now.
void connect(Surface_input& input, const Flow_options& options, Session& session)
{
  if (options.connectivity == Connectivity::keep) return;
  const Delaunay_faces made =
      make_delaunay(input, options.request.surface.mollification.value_or(0));
  session.report().set("result/connectivity/flips", made.flips);
  session.report().set("result/connectivity/face_before", made.face_before);
  session.report().set("result/connectivity/changed_faces", made.changed);
  if (made.flips == 0) return;
  session.note(count_of(static_cast<std::size_t>(made.flips), "edge") +
               " flipped: " + std::to_string(made.changed.size()) + " of " +
               count_of(made.face_before.size(), "face") +
               " have other corners, and the properties of the face in whose place they are");
}

void flow(const Flow_options& options, Session& session)
{
  const bool is_whole = !session.options().each_component;
  require_writable(session.options().output);
  Surface_input input = read_suitable_surface(options.input, session,
                                              flat_faces(options.request.surface.mollification));
  connect(input, options, session);
  if (!is_whole) require_no_snapshots(options);
  Transformed_surface surface{input.mesh.positions()};
  CGP::Flow_report report;
  each_component(input, session, [&](const Component& component, Session& own) {
    const Flow_solution solution = flowed(component.input, options, own);
    if (!is_whole) throw_if_interrupted();
    surface.positions(Eigen::indexing::all, component.vertices) = solution.positions;
    report = solution.report;
  });
  write_result(input, surface, session);
  if (is_whole) throw_if_interrupted_after(report, session);
}

}  // namespace

Command flow_command()
{
  return make_command<Flow_options>("flow", flow_about, add_options, files, flow);
}

}  // namespace conformal
