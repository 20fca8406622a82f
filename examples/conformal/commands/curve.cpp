// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "keyed_options.h"
#include "option_groups.h"

#include "conformal/curves/Curve_flows.h"
#include "conformal/curves/Curve_options.h"
#include "conformal/curves/Pictures.h"
#include "conformal/curves/curve_report.h"
#include "conformal/curves/refine_curve.h"
#include "conformal/io/file/Temporary_file.h"
#include "conformal/io/read_plane_curves.h"
#include "conformal/process/Failure.h"
#include "conformal/process/Progress.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"

#include <filesystem>
#include <optional>
#include <system_error>

namespace conformal {
namespace {

const char* const curve_about =
    "Smooths curves in the plane without stretching them: every edge keeps its length, and every\n"
    "closed curve its turning number. Those that turn k times become circles run through k times,\n"
    "those that do not turn a figure eight, open ones straight.\n"
    "Reads SVG (path, polygon, polyline), CSV (x,y per line, an empty line between), OBJ (l);\n"
    "writes them too, by the extension of the output; in CSV, a closed curve ends with a "
    "repetition\n"
    "of its first point, one row more than it has points. Ends early where the energy has "
    "settled.\n"
    "When interrupted (Ctrl-C, SIGTERM), it writes the curves after the last complete step, and\n"
    "ends with exit code 130 or 143; a second signal ends it at once.\n"
    "Example: conformal curve star.svg --steps 60 --time-step 0.05 --animate -o star_flow.svg";

void add_options(CLI::App& command, Curve_options& curve, Common_options& common)
{
  command.add_option("input", curve.input, "file with curves: SVG, CSV or OBJ")->required();
  command.add_option("--steps", curve.steps, "how many steps at most")
      ->check(above_zero)
      ->capture_default_str();
  command
      .add_option("--time-step", curve.time_step,
                  "what can be smoothed is multiplied by 1 - 2 T in a step: 0.5 goes furthest, "
                  "small ones show the way")
      ->check(between_zero_and_one)
      ->capture_default_str();
  add_choice(command, "--ends", curve.ends, {"detect", "closed", "open"},
             "whether the last point is followed by the first; detect: as the file says (Z, "
             "polygon, a last point that repeats the first), and in CSV where the gap is no longer "
             "than the longest edge");
  add_choice(advanced(command), "--closing", curve.closing, {"exact", "least-squares"},
             "how closed curves are kept closed: without stretching an edge, or by a little of it");
  advanced(command)
      .add_option("--samples", curve.samples,
                  "points of each Bezier segment, and of a quarter of an ellipse")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command
      .add_option("--pieces", curve.pieces,
                  "divide long edges, which cannot bend, until none is longer than 1/PIECES of the "
                  "curve; 0 leaves all as they are; by default 200 for SVG, else 0")
      ->check(CLI::Range(0, 100000000));
  command
      .add_option("--every", curve.every,
                  "write every so many steps a snapshot, OUTPUT with the number of the step: "
                  "star_0005.svg; with --animate, the steps from one picture to the next")
      ->check(above_zero);
  command.add_flag("--animate", curve.animate,
                   "the output, an SVG file, shows the curves on their way, in a browser");
  command.add_option("--seconds", curve.seconds, "of the animation")
      ->check(above_zero)
      ->needs("--animate")
      ->capture_default_str();
  add_output(command, common)->required();
}

Files files(const Curve_options& curve)
{
  return {{"the input", curve.input, Named_file::Role::replaceable}};
}

// Far above rounding, which is some 1e-16 by the share of an edge in the whole curve.
constexpr double largest_distortion = 1e-6;

void require_usable(const Curve_options& options, const std::string& output)
{
  require_curve_format(output);
  if (options.animate && *curve_format_of(output) != Curve_format::svg)
    throw Failure(Exit_code::usage, "--animate wants an output that ends in .svg, not " + output);
  std::error_code ignored;
  const auto status = std::filesystem::status(output, ignored);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status))
    Temporary_file probe(output);
}

// A drawing has its edges as long as they happen to be; in data every point has a meaning.
int pieces_of(const Curve_options& options)
{
  return options.pieces.value_or(*curve_format_of(options.input) == Curve_format::svg ? 200 : 0);
}

std::vector<Plane_curve> read(const Curve_options& options, Session& session)
{
  Curve_reading reading;
  reading.samples = options.samples;
  if (options.ends != Ends_choice::detect) reading.are_closed = options.ends == Ends_choice::closed;
  std::vector<std::string> notes;
  std::vector<Plane_curve> curves = read_plane_curves(options.input, reading, notes);
  if (session.options().strict && !notes.empty()) throw unsuitable(options.input, notes.front());
  session.note_all(notes);
  if (const int pieces = pieces_of(options); pieces > 0)
    for (Plane_curve& curve : curves) refine(curve, pieces);
  session.end_stage("read");
  return curves;
}

void flow(Curve_flows& flows, const Curve_options& options, Session& session, Pictures& pictures,
          std::optional<Patience>& patience)
{
  Progress progress = session.progress();
  pictures.take(flows, 0);
  for (int step = 1; step <= options.steps && signal_received() == 0; ++step) {
    progress.show({"step", (step - 1.) / options.steps,
                   "step " + std::to_string(step) + " of " + std::to_string(options.steps), step});
    if (!flows.step()) break;
    if (!patience) patience.emplace();  // there is something to write
    pictures.take(flows, step);
  }
  progress.clear();
  if (flows.size_of_steps() == 0) throw_if_interrupted();
  session.end_stage("flow");
}

/// Notes which curves got stuck. \returns what is wrong with all of them, empty if nothing
std::string fault_of(const Curve_flows& flows, const Curve_options& options, Session& session)
{
  std::size_t stuck = 0;
  for (const Curve_flows::One& one : flows.all())
    if (one.stop == CGP::Curve_step_report::Stop::step_failed) {
      stuck += one.steps.empty();
      session.note(one.name + " stopped after " + count_of(one.steps.size(), "step") +
                   ": it would not close up, or not become less bent");
    }
  const double distortion = flows.length_distortion();
  if (stuck == flows.all().size())
    return "no step could be made; try: more points on the curve, or a smaller --time-step";
  if (options.closing == Closing_choice::exact && !(distortion <= largest_distortion))
    return "an edge has changed its length by a share of " + text_of(distortion, 3);
  return {};
}

void curve(const Curve_options& options, Session& session)
{
  require_usable(options, session.options().output);
  Curve_flows flows(read(options, session), options);
  Pictures pictures(options, session);
  std::optional<Patience> patience;  // until all is written
  flow(flows, options, session, pictures, patience);
  tell_curves(flows, session.report());
  session.conclude({fault_of(flows, options, session)}, On_fault::refuse, options.input);
  pictures.write_result(flows);
  session.end_stage("write");
  if (signal_received() == 0) return;
  session.keep_report();
  throw_if_interrupted("the curves after " + count_of(flows.size_of_steps(), "step") +
                       " were written to " + session.options().output);
}

}  // namespace

Command curve_command()
{
  return make_command<Curve_options>("curve", curve_about, add_options, files, curve);
}

}  // namespace conformal
