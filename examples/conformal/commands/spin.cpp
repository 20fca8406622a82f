// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "keyed_options.h"
#include "option_groups.h"

#include "conformal/input/boundary_condition.h"
#include "conformal/input/rho.h"
#include "conformal/process/Failure.h"
#include "conformal/process/text.h"
#include "conformal/transform/deform.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace conformal {
namespace {

const char* const spin_about =
    "Deforms a surface conformally so that its mean curvature changes by rho.\n"
    "rho is in 1/length of the normalised frame (the middle of the bounding box at 0, its "
    "diagonal\n"
    "2), positive rho bulges outward, constants have no effect on closed surfaces. The output has\n"
    "the vertex properties quality (quasi-conformal error, 1 is perfect) and rho; normals are "
    "left\n"
    "out.\n"
    "On surfaces with handles (genus > 0) or several boundary loops the part of rho is left out\n"
    "with which they would not close up, and the rest is reached in as many steps as it takes; "
    "the\n"
    "table tells how much. A boundary is free, unless --boundary says what it keeps.\n"
    "Lengths change by a factor of 2 at most (--max-scale), on 98 % of the area: what would\n"
    "collapse limbs is taken out of rho, and the table tells how much was kept.\n"
    "--filter keeps the large features of rho, the small ones, or lifts these out.\n"
    "--mollify takes faces as thin as they may be, also of area zero, which are refused "
    "otherwise;\n"
    "it is tried, and told, where a result does not verify without.\n"
    "A result that does not verify is not written, and the exit code is 1.\n"
    "Example: conformal spin bear.off --rho-expression '1.5*sin(5*y)' -o bear_spin.ply\n"
    "Example: conformal spin bear.obj --paint fur.png --filter unsharp --amplitude 8 -o bear.ply";

const char* const for_eigenvectors = "; without effect unless --max-scale is none";

void add_options(CLI::App& command, Spin_options& spin, Common_options& common)
{
  CGP::Spin_transformation_options& request = spin.request;
  add_input(command, spin.input);
  add_transformation(command, common);
  add_rho(command, spin.rho)->require_option(1);
  add_filter(command, spin.rho.filter);
  add_boundary(command, request.boundary);
  add_lambda(command, spin.lambda);
  add_solver(command, request.solvers);
  request.scales.bound = CGP::internal::default_scale_bound;
  add_scale_control(command, spin.scales, request.scales.bound);
  add_period_defect(command, request.max_period_defect);
  spin.second_try = 1e-6;
  add_mollification(command, request.mollification, tried_otherwise)
      ->each([&spin](const std::string&) { spin.second_try.reset(); });
  add_choice(advanced(command), "--problem", request.dirac.problem, {"standard", "generalized"},
             std::string("standard, or generalized for rho on faces where that can be trusted") +
                 for_eigenvectors);
  command.add_flag_callback(
      "--open-handles", [&request] { request.exactness.reset(); },
      "apply rho in one step, also the part of it that shears handles and holes");
  command.add_flag("--exact-class", request.exact_conformal_class,
                   "move the result to the exact discrete conformal class: length cross-ratios "
                   "are kept to rounding");
  add_eigenvector(command, request.dirac, for_eigenvectors);
  add_limits(command, request.limits, spin.force);
}

Files files(const Spin_options& spin)
{
  return {{"the input", spin.input, Named_file::Role::replaceable},
          {"--rho-file", spin.rho.file},
          {"--paint", spin.rho.image}};
}

/// on the whole surface
CGP::internal::Scale_control scale_control(const Surface_input& input, const Spin_options& spin)
{
  const Scale_options& scales = spin.scales;
  CGP::internal::Scale_control control = spin.request.scales;
  control.factors = vertex_numbers(input, "--target-scale-expression", scales.target_expression,
                                   scales.target_property);
  control.weights =
      vertex_numbers(input, "--lock-expression", scales.lock_expression, scales.lock_property);
  const bool is_used = control.factors.size() > 0 || control.weights.size() > 0;
  if (is_used && !control.bound)
    throw Failure(Exit_code::usage,
                  "wanted and locked sizes are for a bound; try: without --max-scale none");
  control.weights = 99 * control.weights.array() + 1;  // of locked places 100
  return control;
}

void require_possible(const Surface_input& input, const Spin_options& spin)
{
  require_boundary_to_keep(input, spin.request.boundary);
  if (spin.request.dirac.problem == CGP::Dirac_options::Eigenproblem::generalized &&
      !CGP::topology(input.mesh).is_closed())
    throw unsuitable(
        input.file.path,
        "the generalized problem wants a closed surface; try: --advanced problem=standard");
}

std::string easier(const Spin_options& spin)
{
  const CGP::Boundary_condition& kept = spin.request.boundary;
  const bool is_mollified = spin.request.mollification || spin.second_try;
  const std::string usual = text_of(CGP::internal::default_scale_bound);
  const std::string bound = spin.request.scales.bound ? "" : "--max-scale " + usual + ", ";
  const bool has_tangents =
      kept.kind == CGP::Boundary_condition::Kind::directions && !kept.is_self_adjoint();
  const std::string boundary = has_tangents ? "--boundary binormals, " : "";
  return bound + boundary +
         (is_mollified ? "a weaker rho" : "a weaker rho, --mollify for thin faces");
}

/// \param rho in 1/length
Spin_problem problem_of(CGP::Curvature_potential rho, const Spin_options& spin)
{
  if (spin.request.dirac.problem == CGP::Dirac_options::Eigenproblem::generalized &&
      rho.on == CGP::Curvature_potential::On::vertices)
    throw Failure(Exit_code::usage, "the generalized problem wants rho on faces; try: --on faces");
  return {std::move(rho), spin.request, false, spin.second_try};
}

// On a closed surface, a constant shifts the eigenvalue of the Dirac operator, and nothing else.
void note_constant_rho(const CGP::Curvature_potential& rho, Session& session)
{
  const double low = rho.values.minCoeff(), high = rho.values.maxCoeff();
  const double rounding = 1e-12 * std::max({1., std::abs(low), std::abs(high)});
  if (high - low > rounding) return;
  session.note("rho is constant (" + text_of(high) +
               "), so nothing has changed; try: one that varies, such as sin(5*y)");
}

void spin(const Spin_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input =
      read_suitable_surface(options.input, session, flat_faces(options.request.mollification));
  if (!session.options().each_component) require_possible(input, options);
  Transformed_surface surface = Transformed_surface::unchanged(input.mesh);
  surface.rho = read_rho(input, options.rho);
  const CGP::internal::Scale_control scales = scale_control(input, options);
  const double unit = User_frame(input.mesh).unit();
  const bool has_effect =
      scales.factors.size() > 0 || options.request.exact_conformal_class;  // without rho
  each_component(input, session, [&](const Component& component, Session& own) {
    require_possible(component.input, options);
    if (!has_effect && CGP::topology(component.input.mesh).is_closed())
      note_constant_rho(on_component(surface.rho, component, 1), own);
    Spin_problem problem = problem_of(on_component(surface.rho, component, 1 / unit), options);
    CGP::internal::Scale_control& own_scales = problem.request.scales;
    if (scales.factors.size() > 0) own_scales.factors = scales.factors(component.vertices);
    if (scales.weights.size() > 0) own_scales.weights = scales.weights(component.vertices);
    surface.set(component, deform(component.input, problem, options, easier(options), own));
  });
  write_result(input, surface, session, options.lambda);
}

}  // namespace

Command spin_command()
{
  return make_command<Spin_options>("spin", spin_about, add_options, files, spin);
}

}  // namespace conformal
