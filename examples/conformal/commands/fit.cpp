// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "keyed_options.h"
#include "option_groups.h"

#include "conformal/input/Expression.h"
#include "conformal/input/boundary_condition.h"
#include "conformal/input/rho.h"
#include "conformal/input/same_faces.h"
#include "conformal/process/Failure.h"
#include "conformal/process/text.h"
#include "conformal/transform/Search_watch.h"
#include "conformal/transform/deform.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace conformal {
namespace {

const char* const fit_about =
    "Deforms a surface conformally, as nearly as it can in the way another program has deformed\n"
    "it. SOURCE and TARGET have the same faces. The result is the nearest in the mean square\n"
    "distance of the vertices, after a similarity, and never farther than SOURCE: conformal, so\n"
    "what only shears and stretches is approached by other means, or undone. It comes no nearer\n"
    "by wrinkles: the normals count too, see --advanced help. A boundary takes\n"
    "its tangents or binormals from TARGET, where that is possible. With --keep-curvature, the\n"
    "result has the curvature of TARGET, wherever that is. It has the vertex property quality\n"
    "(quasi-conformal error against the source, 1 is perfect) and the face property rho.\n"
    "A result that does not verify is not written, and the exit code is 1.\n"
    "Example: conformal fit bear.off bear_posed.off -o bear_fit.ply";

struct Fit_options {
  std::string source, target;
  CGP::Nearest_spin_options request;
  double blend = 0;    ///< 0 is conformal, 1 nearest to the target
  std::string scale;   ///< a formula of factors for the scales of the target, none if empty
  std::string lambda;  ///< the name of the vertex properties, none if empty
  bool force = false;
};

/// what came of it
struct Fit_solution : CGP::Nearest_spin_result {
  int sign_conflicts = 0;  ///< edges across which the rotations of the target jump
};

void add_options(CLI::App& command, Fit_options& fit, Common_options& common)
{
  command.add_option("source", fit.source, "mesh file, - for standard input")->required();
  command.add_option("target", fit.target, "the deformed mesh, with the same faces")->required();
  command
      .add_option("--blend", fit.blend,
                  "t in (1 - t) lambda + t mu, 0 for conformal, 1 for nearest to the target")
      ->check(finite)
      ->capture_default_str();
  command.add_flag("--keep-curvature", fit.request.keep_curvature,
                   "keep the curvature of the target, and do not search for the nearest surface");
  advanced(command)
      .add_option("--normal-weight", fit.request.normal_weight,
                  "how much normals count beside positions; 0 comes nearest in positions, if need "
                  "be by wrinkles")
      ->check(finite)
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  advanced(command)
      .add_option("--shear", fit.request.shear,
                  "how far from conformal it may be: the largest closure residual; .0125 is nearer "
                  "to conformal and farther from the target than the default of .05")
      ->check(above_zero);
  add_distance_tolerance(command, fit.request.distance_tolerance);
  add_max_scale(command, fit.request.surface.scales.bound);
  command
      .add_option("--scale-expression", fit.scale,
                  "keeps the curvature, and multiplies the scales |mu|^2 of the target that are "
                  "blended in (a conformal surface has its own) by a formula above 0 in x y z "
                  "(normalised frame) and nx ny "
                  "nz (outward normal)")
      ->check(formula)
      ->needs("--blend");
  const auto choose = [&fit](const std::string& word) {
    using CGP::Boundary_condition;
    fit.request.direction = word == "tangents" ? Boundary_condition::tangents().direction
                                               : Boundary_condition::binormals().direction;
  };
  command
      .add_option_function<std::string>("--boundary", choose,
                                        "which directions the boundary takes from the target")
      ->check(CLI::IsMember({"tangents", "binormals"}))
      ->default_str("tangents");
  add_mollification(command, fit.request.surface.mollification);
  add_lambda(command, fit.lambda);
  add_transformation(command, common);
  add_eigenvector(command, fit.request.surface.dirac);
  add_limits(command, fit.request.surface.limits, fit.force);
}

Files files(const Fit_options& fit)
{
  return {{"the input", fit.source, Named_file::Role::replaceable}, {"the target", fit.target}};
}

/// Evaluates a formula for the factors at the vertices; empty if there is no formula.
Eigen::VectorXd scale_factors(const Surface_input& input, const std::string& text)
{
  if (text.empty()) return {};
  Expression expression(text, "--scale-expression");
  const User_frame frame(input.mesh);
  const CGP::Points normals = CGP::vertex_normals(input.mesh);
  Eigen::VectorXd factors(input.mesh.size_of_vertices());
  for (int v = 0; v < factors.size(); ++v) {
    factors[v] = expression(frame(input.mesh.position(v)), normals.col(v));
    if (!(factors[v] > 0) || !std::isfinite(factors[v]))
      throw unsuitable(input.file.path, "--scale-expression is " + text_of(factors[v]) + " at " +
                                            name_of_vertex(input, v) +
                                            ", wanted finite numbers above 0; try: exp(...)");
  }
  return factors;
}

/// Tells how far the target is from the surface, and from a conformal one.
void tell_target(const CGP::Mesh_view& mesh, const CGP::Mesh_view& target,
                 const Fit_solution& solution, Session& session)
{
  Report& report = session.report();
  const CGP::Mesh_view measured = measured_part(mesh, solution.report.mollification.share > 0);
  const auto Q = CGP::conformality(measured, target.positions(),
                                   CGP::neighbourhood_normals(measured, target.positions()))
                     .quasi_conformal;
  const std::string place = "result/target/quasi_conformal/";
  report.tell(place + "mean", "quasi-conformal error of the target, mean", Q.mean);
  report.set(place + "p99", Q.p99);
  report.tell(place + "max", "quasi-conformal error of the target, max", Q.max);
  report.set("result/target/sign_conflicts", solution.sign_conflicts);
  if (solution.report.converged) {
    const auto a = CGP::align(solution.positions, target.positions());
    report.tell("result/distance/rms", "distance from the target, rms / diagonal",
                solution.distance);
    report.tell("result/distance/source", "likewise of the source", solution.source_distance);
    report.tell("result/distance/max", "distance from the target, max / diagonal", a.max);
    report.tell("result/distance/normals", "normals from those of the target, rms",
                solution.normal_distance);
    report.tell("result/distance/source_normals", "likewise of the source",
                solution.source_normal_distance);
  }
  report.end_table();
  if (solution.sign_conflicts > 0)
    session.note("the rotations of the target jump by more than half a turn across " +
                 count_of(static_cast<std::size_t>(solution.sign_conflicts), "edge"));
}

/// \param factors of the scales of the target; none if empty
Fit_solution solve(const CGP::Mesh_view& mesh, const CGP::Points& target,
                   const Eigen::VectorXd& factors, const Fit_options& options, Session& session)
{
  Search_watch watch(session, options.request.surface.dirac.tolerance);
  CGP::Nearest_spin_transformation nearest(mesh, target, "fit", options.request);
  if (factors.size() > 0) nearest.scale_lengths(factors);
  CGP::Nearest_spin_result result = nearest.transform(std::ref(watch));
  if (options.blend != 0 && result.report) result = nearest.blend(result, options.blend);
  watch.end(result.report);
  return {std::move(result), nearest.sign_conflicts()};
}

/// The condition at the boundary with which the surface was found; notes if it is another one.
CGP::Boundary_condition used_condition(const CGP::Boundary_condition& given,
                                       const Fit_solution& solution, Session& session)
{
  if (given.kind == CGP::Boundary_condition::Kind::free || solution.direction == given.direction)
    return given;
  session.note("no surface near to the target has the boundary directions that were requested: " +
               std::string(!solution.direction            ? "the boundary is free"
                           : solution.direction->x() == 0 ? "it has the binormals of the target"
                                                          : "it has the tangents of the target"));
  if (!solution.direction) return CGP::Boundary_condition::free();
  return CGP::Boundary_condition::directions(*solution.direction, given.targets);
}

/// Solves the problem on a surface in one component, tells what came of it, and concludes.
Fit_solution fit_surface(const Surface_input& input, const CGP::Boundary_condition& boundary,
                         const CGP::Mesh_view& target, const Eigen::VectorXd& factors,
                         const Fit_options& options, Session& session)
{
  Fit_solution solution = solve(input.mesh, target.positions(), factors, options, session);
  session.begin_stage();
  tell_target(input.mesh, target, solution, session);
  tell_solution(input, used_condition(boundary, solution, session), solution.report,
                session.outcome());
  conclude(solution, options.force, "a target that is bent and sheared less", session,
           session.input());
  return solution;
}

void fit(const Fit_options& options, Session& session)
{
  const Flat_faces flat = flat_faces(options.request.surface.mollification);
  require_writable(session.options().output);
  const Surface_input input = read_suitable_surface(options.source, session, flat);
  const CGP::Mesh_view target = read_surface_like(input, options.target, flat).mesh;
  session.note_all(notes_of_repair_alike(input, {options.target}));
  const Eigen::VectorXd factors = scale_factors(input, options.scale);
  const double unit = User_frame(input.mesh).unit();
  Transformed_surface surface = Transformed_surface::unchanged(input.mesh);
  surface.rho =
      CGP::Curvature_potential::on_faces(Eigen::VectorXd::Zero(input.mesh.size_of_faces()));
  const bool is_bounded = !CGP::topology(input.mesh).is_closed();
  CGP::Boundary_condition boundary = CGP::Boundary_condition::free();
  if (is_bounded) boundary = directions_of(input, target, options.request.direction);
  each_component(input, session, [&](const Component& component, Session& own) {
    Eigen::VectorXd own_factors = factors;
    if (factors.size() > 0) own_factors = factors(component.vertices);
    const Fit_solution solution =
        fit_surface(component.input, on_component(boundary, input.mesh, component),
                    on_component(target, component), own_factors, options, own);
    surface.set(component, solution);
    surface.rho.values(component.faces) = unit * at_faces(component.input.mesh, solution.rho);
  });
  write_result(input, surface, session, options.lambda);
}

}  // namespace

Command fit_command()
{
  return make_command<Fit_options>("fit", fit_about, add_options, files, fit);
}

}  // namespace conformal
