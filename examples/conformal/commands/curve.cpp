// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "curve.h"

#include "conformal/curves/Curve_flows.h"
#include "conformal/curves/curve_report.h"
#include "conformal/curves/refine_curve.h"
#include "conformal/io/file/Temporary_file.h"
#include "conformal/io/read_plane_curves.h"
#include "conformal/io/write_plane_curves.h"
#include "conformal/process/Failure.h"
#include "conformal/process/Progress.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"
#include "conformal/transform/write_result.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

namespace conformal {
namespace {

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

/// Takes pictures on the way: files of their own, or the frames of an animation.
class Pictures {
 public:
  Pictures(const Curve_options& options, Session& session) : m_options(options), m_session(session)
  {}

  void take(const Curve_flows& flows, int step)
  {
    if (m_options.animate && step % std::max(m_options.every, 1) == 0)
      m_frames.push_back(flows.curves());
    else if (!m_options.animate && step > 0 && m_options.every > 0 && step % m_options.every == 0)
      write_snapshot(flows, step);
  }

  void write_result(const Curve_flows& flows)
  {
    const std::string& output = m_session.options().output;
    if (!m_options.animate) return write_plane_curves(output, flows.curves());
    m_frames.push_back(flows.curves());  // the last one stays a little longer
    write_animation(output, m_frames, m_options.seconds);
  }

 private:
  void write_snapshot(const Curve_flows& flows, int step)
  {
    const std::string path = snapshot_path(m_session.options().output, step);
    std::error_code ignored;
    if (std::filesystem::equivalent(path, m_options.input, ignored))
      return m_session.note(path + " is not written: it is the input");
    write_plane_curves(path, flows.curves());
  }

  const Curve_options& m_options;
  Session& m_session;
  std::vector<Curve_picture> m_frames;
};

void flow(Curve_flows& flows, const Curve_options& options, Session& session, Pictures& pictures,
          std::optional<Patience>& patience)
{
  Progress progress(session.options().quiet);
  pictures.take(flows, 0);
  for (int step = 1; step <= options.steps && signal_received() == 0; ++step) {
    progress.show("step " + std::to_string(step) + " of " + std::to_string(options.steps),
                  (step - 1.) / options.steps);
    if (!flows.step()) break;
    if (!patience) patience.emplace();  // there is something to write
    pictures.take(flows, step);
  }
  progress.clear();
  if (flows.size_of_steps() == 0) throw_if_interrupted();
  session.end_stage("flow");
}

void tell(const Curve_flows& flows, Session& session)
{
  report_curves(flows, session.report());
  if (flows.all().size() == 1) session.print(step_grid(flows.all().front()).text() + "\n");
  session.print(curve_grid(flows).text());
}

void verify(const Curve_flows& flows, const Curve_options& options, Session& session)
{
  std::size_t stuck = 0;
  for (const Curve_flows::One& one : flows.all())
    if (one.stop == CGP::Curve_step_report::Stop::step_failed) {
      stuck += one.steps.empty();
      session.note(one.name + " stopped after " + count_of(one.steps.size(), "step") +
                   ": it would not close up, or not become less bent");
    }
  const double distortion = flows.length_distortion();
  std::string fault;
  if (stuck == flows.all().size())
    fault = "no step could be made; try: more points on the curve, or a smaller --time-step";
  else if (options.closing == Closing_choice::exact && !(distortion <= largest_distortion))
    fault = "an edge has changed its length by a share of " + text_of(distortion, 3);
  session.report().set("verified", fault.empty());
  if (!fault.empty()) throw Failure(Exit_code::failed, options.input + ": " + fault);
}

}  // namespace

void curve(const Curve_options& options, Session& session)
{
  require_usable(options, session.options().output);
  Curve_flows flows(read(options, session), options);
  Pictures pictures(options, session);
  std::optional<Patience> patience;  // until all is written
  flow(flows, options, session, pictures, patience);
  tell(flows, session);
  verify(flows, options, session);
  pictures.write_result(flows);
  session.end_stage("write");
  if (signal_received() == 0) return;
  session.keep_report();
  throw_if_interrupted("the curves after " + count_of(flows.size_of_steps(), "step") +
                       " were written to " + session.options().output);
}

}  // namespace conformal
