// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "blend.h"

#include "conformal/input/rho.h"
#include "conformal/input/same_faces.h"
#include "conformal/process/Failure.h"
#include "conformal/report/Grid.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/report/verification.h"
#include "conformal/transform/deform.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/measure/quasi_conformal_error.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>
#include <Conformal_geometry_processing/spin/turned_binormals.h>

#include <cmath>
#include <filesystem>
#include <system_error>
#include <vector>

namespace conformal {
namespace {

const char* const easier_than_blend = "a --t closer to 0";

/// the pair of surfaces, and the one to which their difference is added
struct Pair {
  Surface_input a, b, start;
  CGP::Mesh_view b_near_a;  ///< placed so that the boundary turns no more than it must
};

struct Frame {
  double t;
  Deformation deformation;
};

Pair read_pair(const Blend_options& options, Session& session)
{
  Surface_input a = read_suitable_surface(options.spin.input, session);
  Surface_input b = read_surface_like(a, options.other);
  Surface_input start = options.onto.empty() ? a : read_surface_like(a, options.onto);
  session.note_all(notes_of_repair_alike(a, {options.other, options.onto}));
  const CGP::Points& p = b.mesh.positions();
  CGP::Mesh_view near(CGP::align(p, a.mesh.positions()).apply(p), a.mesh.corners());
  return {std::move(a), std::move(b), std::move(start), std::move(near)};
}

void tell_equivalence(const Pair& pair, Session& session)
{
  const double Q = CGP::quasi_conformal_error(pair.a.mesh, pair.b.mesh.positions()).mean;
  session.report().set("result/pair/quasi_conformal/mean", Q);
  const double of_coarse_meshes = 1.25;
  if (!(Q <= of_coarse_meshes))
    session.note(pair.b.file.path + " is no conformal image of " + pair.a.file.path +
                 " (mean quasi-conformal error " + text_of(Q, 3) +
                 "): the way does not lead there, but to what has its curvature");
}

/// The values of t in order; the last one belongs to the output.
std::vector<double> values_of_t(const Blend_options& options)
{
  std::vector<double> all;
  for (int k = 0; k + 1 < options.frames; ++k)
    all.push_back(options.from + (options.t - options.from) * k / (options.frames - 1));
  all.push_back(options.t);
  return all;
}

void require_frames_that_overwrite_nothing(const Blend_options& options, const std::string& output)
{
  for (int k = 0; k < options.frames; ++k)
    for (const std::string& input : {options.spin.input, options.other, options.onto}) {
      std::error_code ignored;
      if (std::filesystem::equivalent(snapshot_path(output, k), input, ignored))
        throw Failure(Exit_code::usage, "frame " + std::to_string(k) + " would be written over " +
                                            input + "; try: another name for the output");
    }
}

/// rho of the whole difference, in 1/length of the surface to which it is added
CGP::Curvature_potential whole_difference(const Pair& pair)
{
  return CGP::transferred(CGP::curvature_difference(pair.a.mesh, pair.b.mesh.positions()),
                          pair.a.mesh, pair.start.mesh);
}

Frame frame_at(double t, const Pair& pair, const CGP::Curvature_potential& whole,
               const Blend_options& options, Session& session)
{
  Spin_problem problem;
  problem.rho = {whole.on, t * whole.values};
  if (!CGP::topology(pair.start.mesh).is_closed()) {
    problem.boundary = CGP::Boundary_condition::binormals(
        CGP::turned_binormals(pair.a.mesh, pair.b_near_a, pair.start.mesh, t));
    problem.closes_loops = false;  // the prescribed data determine the loops
  }
  const auto solve = [&](const Go_further& go_further) {
    return solve_spin(pair.start.mesh, problem, options.spin, session.options(), go_further);
  };
  Frame frame{t, {problem.rho, problem.boundary, {}}};
  frame.deformation.rho.values *= User_frame(pair.start.mesh).unit();
  frame.deformation.solution = watched(solve, session.options(), "t = " + text_of(t, 4) + ", ");
  return frame;
}

/// after the certificate of the last one
void tell_frames(const std::vector<Frame>& frames, const Pair& pair, Session& session)
{
  Grid grid({"t", "energy/4pi", "closure", "Q mean", "Q max", "flips", "from B"});
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const Spin_solution& solution = frames[k].deformation.solution;
    const CGP::Mesh_view surface(solution.positions, pair.a.mesh.corners());
    const CGP::Conformality& map = solution.report.conformality;
    const double energy = CGP::willmore_energy(surface);
    const double distance = CGP::align(solution.positions, pair.b.mesh.positions()).rms;
    const std::string place = "steps/" + std::to_string(k);
    session.report().set(place + "/t", frames[k].t);
    session.report().set(place + "/energy", energy);
    session.report().set(place + "/closure_residual", solution.report.closure_residual);
    session.report().set(place + "/quasi_conformal/mean", map.quasi_conformal.mean);
    session.report().set(place + "/quasi_conformal/max", map.quasi_conformal.max);
    session.report().set(place + "/flipped_faces", map.flipped_faces);
    session.report().set(place + "/distance", distance);
    grid.add({text_of(frames[k].t, 4), text_of(energy / (4 * std::acos(-1.))),
              text_of(solution.report.closure_residual, 3), text_of(map.quasi_conformal.mean, 5),
              text_of(map.quasi_conformal.max, 5), std::to_string(map.flipped_faces),
              text_of(distance, 3)});
  }
  session.print("\n" + grid.text());
}

void write_frames(const std::vector<Frame>& frames, const Pair& pair, const Blend_options& options,
                  Session& session)
{
  const std::string& output = session.options().output;
  const auto write = [&](const std::string& path, const Frame& frame) {
    write_deformation(path, pair.start, frame.deformation, options.spin.lambda, session);
  };
  for (int k = 0; k < options.frames; ++k)
    write(snapshot_path(output, k), frames[static_cast<std::size_t>(k)]);
  write(output, frames.back());
  session.end_stage("write");
}

}  // namespace

void blend(const Blend_options& options, Session& session)
{
  require_writable(session.options().output);
  require_frames_that_overwrite_nothing(options, session.options().output);
  const Pair pair = read_pair(options, session);
  tell_equivalence(pair, session);
  const CGP::Curvature_potential whole = whole_difference(pair);
  session.end_stage("prepare");
  std::vector<Frame> frames;
  for (const double t : values_of_t(options)) {
    if (!frames.empty()) session.end_stage("frames");
    frames.push_back(frame_at(t, pair, whole, options, session));
  }
  session.begin_stage();
  session.report().set("result/t", options.t);
  tell_certificate(pair.start, frames.back().deformation, session);
  tell_frames(frames, pair, session);
  for (const Frame& frame : frames)
    verify("t = " + text_of(frame.t, 4), pair.start, frame.deformation.solution, options.spin,
           easier_than_blend, session);
  keep_exhibit(pair.start, frames.back().deformation.solution.positions, session);
  write_frames(frames, pair, options, session);
}

}  // namespace conformal
