// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "numbered_outputs.h"
#include "option_checks.h"
#include "option_groups.h"

#include "conformal/input/rho.h"
#include "conformal/input/same_faces.h"
#include "conformal/io/file/snapshot_path.h"
#include "conformal/process/Failure.h"
#include "conformal/process/text.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/transform/Search_watch.h"
#include "conformal/transform/deform.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/solve_spin.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Conformal_geometry_processing/spin/curvature_difference.h>

#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace conformal {
namespace {

const char* const blend_about =
    "Goes from A towards B, or beyond: adds t times the difference of their mean curvature\n"
    "half-densities. A and B have the same faces and are conformally equivalent, as results of\n"
    "conformal spin and flow are to their inputs; so is every surface on the way. The difference\n"
    "is corrected so that t = 1 is B to the eye, or the conformal surface nearest to it. Area and\n"
    "centroid are those of A; at a boundary the binormals turn evenly. --onto adds the\n"
    "difference to a third surface. The output has the vertex property quality\n"
    "(quasi-conformal error, 1 is perfect) and the face property rho.\n"
    "What does not verify is not written, and the exit code is 1.\n"
    "Example: conformal blend bear.off bear_spin.ply --t 1.5 -o bear_more.ply";

struct Blend_options {
  Spin_options spin;         ///< what this command has in common with that; input is A
  std::string other, onto;   ///< files; the difference is added to A, unless there is another
  double t = 0.5, from = 0;  ///< of B - A; the first of the frames
  int frames = 0;
  bool keep_curvature = false;  ///< the plain difference, wherever t = 1 is then
  double distance_tolerance = CGP::Nearest_spin_options().distance_tolerance;
};

void add_options(CLI::App& command, Blend_options& blend, Common_options& common)
{
  command.add_option("a", blend.spin.input, "mesh file, - for standard input")->required();
  command.add_option("b", blend.other, "mesh file with the same faces")->required();
  command
      .add_option("--t", blend.t,
                  "how much of the difference is added: 0 for A, 1 for B, 2 for twice as far, "
                  "-1 for as far the other way")
      ->check(finite)
      ->capture_default_str();
  command
      .add_option("--onto", blend.onto,
                  "the mesh to which the difference is added, with the same faces (default: A)")
      ->check(not_empty);
  command
      .add_option("--frames", blend.frames,
                  "write so many surfaces on the way, OUTPUT with the number of the frame: "
                  "bear_0000.ply is at --from, the last at --t")
      ->check(CLI::Range(2, 9999));
  command.add_option("--from", blend.from, "t of the first frame")
      ->check(finite)
      ->needs("--frames")
      ->capture_default_str();
  command.add_flag("--keep-curvature", blend.keep_curvature,
                   "add the plain difference of curvature, wherever t = 1 is then");
  add_distance_tolerance(command, blend.distance_tolerance);
  add_max_scale(command, blend.spin.request.scales.bound);
  add_lambda(command, blend.spin.lambda);
  add_solver(command, blend.spin.request.solvers);
  add_transformation(command, common);
  add_eigenvector(command, blend.spin.request.dirac);
  add_limits(command, blend.spin.request.limits, blend.spin.force);
}

Files files(const Blend_options& blend)
{
  const auto role = blend.onto.empty() ? Named_file::Role::replaceable : Named_file::Role::read;
  return {{"the mesh A", blend.spin.input, role},
          {"the mesh B", blend.other},
          {"--onto", blend.onto, Named_file::Role::replaceable}};
}

/// the pair of surfaces, and the one to which their difference is added
struct Trio {
  CGP::Mesh_view a, b, start;
};

/// The values of t in order; the last one belongs to the output.
std::vector<double> values_of_t(const Blend_options& options)
{
  std::vector<double> all;
  for (int k = 0; k + 1 < options.frames; ++k)
    all.push_back(options.from + (options.t - options.from) * k / (options.frames - 1));
  all.push_back(options.t);
  return all;
}

void note_unlike(const CGP::Mesh_view& a, const CGP::Mesh_view& b, const Blend_options& options,
                 Session& session)
{
  const double Q = CGP::quasi_conformal_error(a, b.positions()).mean;
  session.report().set("result/pair/quasi_conformal/mean", Q);
  const double of_coarse_meshes = 1.25;
  if (!(Q <= of_coarse_meshes))
    session.note(options.other + " is not a conformal image of " + options.spin.input +
                 " (mean quasi-conformal error " + text_of(Q, 3) +
                 "): the way does not lead there, but to what has its curvature");
}

CGP::Curvature_potential searched_difference(const Trio& meshes, const Blend_options& options,
                                             Session& session)
{
  const CGP::Dirac_options& dirac = options.spin.request.dirac;
  Search_watch watch(session, dirac.tolerance, "difference, ");
  CGP::Curvature_potential rho = CGP::nearest_curvature_difference(
      meshes.a, meshes.b.positions(), options.distance_tolerance, dirac, std::ref(watch), "blend");
  watch.end();
  return rho;
}

/// in 1/length of the surface to which it is added
CGP::Curvature_potential difference(const Trio& meshes, const Blend_options& options,
                                    Session& session)
{
  const CGP::Curvature_potential rho =
      options.keep_curvature ? CGP::curvature_difference(meshes.a, meshes.b.positions())
                             : searched_difference(meshes, options, session);
  return CGP::transferred(rho, meshes.a, meshes.start);
}

/// a surface on the way
struct Frame {
  double t;
  Spin_problem problem;
  CGP::Spin_result solution;
};

std::vector<Frame> solve_frames(const Trio& meshes, const Blend_options& options, Session& session)
{
  const CGP::Curvature_potential whole = difference(meshes, options, session);
  std::vector<Frame> frames;
  for (const double t : values_of_t(options)) {
    if (!frames.empty()) session.end_stage("frames");
    const Spin_problem problem{
        {whole.on, t * whole.values},
        CGP::blend_request(meshes.a, meshes.b.positions(), meshes.start, t, options.spin.request)};
    Search_watch watch(session, problem.request.dirac.tolerance, "t = " + text_of(t, 4) + ", ");
    CGP::Spin_result solution = solve_spin(meshes.start, problem, std::ref(watch));
    watch.end(solution.report);
    frames.push_back({t, problem, std::move(solution)});
  }
  return frames;
}

/// after the certificate of the last one
void tell_frames(const std::vector<Frame>& frames, const CGP::Mesh_view& b, Report& report)
{
  Grid grid({"t", "energy/4pi", "closure", "Q mean", "Q max", "flips", "from B"});
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const CGP::Spin_result& solution = frames[k].solution;
    const CGP::Conformality& map = solution.report.conformality;
    const double energy = CGP::willmore_energy(CGP::Mesh_view(solution.positions, b.corners()));
    const double distance = CGP::align(solution.positions, b.positions()).rms;
    const std::string place = "steps/" + std::to_string(k);
    report.set(place + "/t", frames[k].t);
    report.set(place + "/energy", energy);
    report.set(place + "/closure_residual", solution.report.closure_residual);
    report.set(place + "/quasi_conformal/mean", map.quasi_conformal.mean);
    report.set(place + "/quasi_conformal/max", map.quasi_conformal.max);
    report.set(place + "/flipped_faces", map.flipped_faces);
    report.set(place + "/distance", distance);
    grid.add({text_of(frames[k].t, 4), text_of(energy / (4 * std::acos(-1.))),
              text_of(solution.report.closure_residual, 3), text_of(map.quasi_conformal.mean, 5),
              text_of(map.quasi_conformal.max, 5), std::to_string(map.flipped_faces),
              text_of(distance, 3)});
  }
  report.show(grid);
}

/// The frames of a surface in one component, all of which verify.
std::vector<Frame> verified_frames(const Surface_input& start, const Trio& meshes,
                                   const Blend_options& options, Session& session)
{
  note_unlike(meshes.a, meshes.b, options, session);
  std::vector<Frame> frames = solve_frames(meshes, options, session);
  session.begin_stage();
  session.report().set("result/t", options.t);
  const Frame& last = frames.back();
  tell_solution(start, last.problem.request.boundary, last.solution.report, session.outcome());
  tell_frames(frames, meshes.b, session.report());
  for (const Frame& frame : frames)
    conclude(frame.solution, options.spin.force, "a --t closer to 0", session,
             "t = " + text_of(frame.t, 4));
  return frames;
}

void write_frames(const std::vector<Transformed_surface>& surfaces, const Surface_input& start,
                  const Blend_options& options, Session& session)
{
  const std::string& output = session.options().output;
  for (int k = 0; k < options.frames; ++k)
    write_mesh(snapshot_path(output, k),
               result_file(start, surfaces[static_cast<std::size_t>(k)], options.spin.lambda),
               session);
  write_result(start, surfaces.back(), session, options.spin.lambda);
}

void blend(const Blend_options& options, Session& session)
{
  require_writable(session.options().output);
  require_new_files("frame", session.options().output, options.frames,
                    {options.spin.input, options.other, options.onto});
  const Surface_input a = read_suitable_surface(options.spin.input, session);
  const CGP::Mesh_view b = read_surface_like(a, options.other).mesh;
  const Surface_input start = options.onto.empty() ? a : read_surface_like(a, options.onto);
  session.note_all(notes_of_repair_alike(a, {options.other, options.onto}));
  const double unit = User_frame(start.mesh).unit();
  Transformed_surface unchanged = Transformed_surface::unchanged(start.mesh);
  unchanged.rho =
      CGP::Curvature_potential::on_faces(Eigen::VectorXd::Zero(start.mesh.size_of_faces()));
  std::vector<Transformed_surface> surfaces(values_of_t(options).size(), unchanged);
  each_component(start, session, [&](const Component& component, Session& own) {
    const Trio meshes{on_component(a.mesh, component), on_component(b, component),
                      component.input.mesh};
    const auto frames = verified_frames(component.input, meshes, options, own);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      surfaces[k].set(component, frames[k].solution);
      surfaces[k].rho.values(component.faces) =
          unit * at_faces(component.input.mesh, frames[k].problem.rho);
    }
  });
  write_frames(surfaces, start, options, session);
}

}  // namespace

Command blend_command()
{
  return make_command<Blend_options>("blend", blend_about, add_options, files, blend);
}

}  // namespace conformal
