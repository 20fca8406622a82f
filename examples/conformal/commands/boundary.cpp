// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "option_groups.h"

#include "conformal/input/boundary_condition.h"
#include "conformal/input/rho.h"
#include "conformal/input/same_faces.h"
#include "conformal/transform/deform.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/operators/mean_curvature.h>

namespace conformal {
namespace {

const char* const boundary_about =
    "Deforms a surface with boundary conformally so that the boundary gets other tangents, "
    "binormals\n"
    "or positions, in one step. The mean curvature half-density stays as it is (a flat surface "
    "becomes\n"
    "a minimal one), or changes by rho as with conformal spin. Directions are absolute, sizes are "
    "not\n"
    "prescribed: area and centroid stay, unless positions are given.\n"
    "Any binormals can be realised, up to a constant gamma that is added to rho, and with several\n"
    "boundary loops the least rho that closes the surface (added_share); so can the tangents of "
    "plane\n"
    "curves, but of others only those that fulfil one condition, which the program checks: the "
    "exit\n"
    "code is 1, and nothing is written, where gamma times the radius stays away from 0.\n"
    "A loop begins at its vertex of smallest number, and has the surface on its left.\n"
    "Example: conformal boundary disk.off --binormal-tilt '40*cos(6*pi*s)' -o flower.ply";

struct Boundary_options {
  Spin_options spin;  ///< what this command has in common with that; without a source, rho is 0
  Prescription_options prescription;
  bool minimal = false;  ///< rho is -H
};

void add_positions(CLI::App& command, CLI::Option* from, Prescription_options& prescription)
{
  command
      .add_option("--position-weight", prescription.position_weight,
                  "weight of these positions against conformality; without it they are exact. With "
                  "it, the boundary moves away from them within a layer of radius / weight")
      ->check(CLI::PositiveNumber);
  auto* curves = command.add_option_group("curves inside", "closed curves, one of");
  curves
      ->add_option("--curves-expression", prescription.curves_expression,
                   "formula: where it is positive, vertices inside the surface form closed curves "
                   "of edges, which are to lie where they do in --positions-from, too")
      ->check(formula)
      ->needs(from);
  curves
      ->add_option("--curves-property", prescription.curves_property,
                   "vertex property with these numbers")
      ->check(not_empty)
      ->needs(from);
  curves->require_option(0, 1);
}

void add_prescription(CLI::App& command, Prescription_options& prescription)
{
  auto* what = command.add_option_group("boundary", "what the boundary becomes, one of");
  what->add_option("--tangents-from", prescription.tangents_from,
                   "has the tangents of this mesh, which has the same faces")
      ->check(not_empty);
  what->add_option("--binormals-from", prescription.binormals_from,
                   "has the binormals of this mesh (tangent x normal, out of the surface)")
      ->check(not_empty);
  CLI::Option* const positions =
      what->add_option("--positions-from", prescription.positions_from,
                       "lies where that of this mesh does, with its normals")
          ->check(not_empty);
  what->add_option("--curve", prescription.curve,
                   "has the tangents of a closed curve: a text file with a point per line, an "
                   "empty line between curves, one for each loop, in the order of conformal info; "
                   "with as many points as the loop has vertices they belong together, else equal "
                   "shares of the lengths do")
      ->check(not_empty);
  what->add_option("--tangent-rotation", prescription.tangent_rotation,
                   "has its tangents turned about the normals, counterclockwise seen from outside, "
                   "by so many degrees: a formula in x y z nx ny nz (normalised frame), s in [0,1) "
                   "along the loop, and loop, the number of it")
      ->check(formula);
  what->add_option("--binormal-tilt", prescription.binormal_tilt,
                   "has its binormals turned towards the normals, by a formula likewise")
      ->check(formula);
  what->require_option(1);
  add_positions(command, positions, prescription);
}

void add_options(CLI::App& command, Boundary_options& boundary, Common_options& common)
{
  Spin_options& spin = boundary.spin;
  add_input(command, spin.input);
  add_transformation(command, common);
  add_prescription(command, boundary.prescription);
  CLI::Option_group* rho = add_rho(command, spin.rho);
  rho->add_flag("--minimal", boundary.minimal,
                "minus the mean curvature: the result is a minimal surface");
  rho->require_option(0, 1);
  add_lambda(command, spin.lambda);
  add_solver(command, spin.request.solvers);
  add_period_defect(command, spin.request.max_period_defect);
  add_eigenvector(command, spin.request.dirac);
  add_limits(command, spin.request.limits, spin.force);
}

Files files(const Boundary_options& boundary)
{
  const Rho_options& rho = boundary.spin.rho;
  const Prescription_options& by = boundary.prescription;
  return {{"the input", boundary.spin.input, Named_file::Role::replaceable},
          {"--rho-file", rho.file},
          {"--paint", rho.image},
          {"--tangents-from", by.tangents_from},
          {"--binormals-from", by.binormals_from},
          {"--positions-from", by.positions_from},
          {"--curve", by.curve}};
}

bool has_source(const Rho_options& rho)
{
  return !(rho.expression.empty() && rho.property.empty() && rho.file.empty() && rho.image.empty());
}

/// rho in the user's frame
CGP::Curvature_potential potential(const Surface_input& input, const Boundary_options& options)
{
  if (has_source(options.spin.rho)) return read_rho(input, options.spin.rho);
  if (!options.minimal) return CGP::no_potential(input.mesh);
  const double unit = User_frame(input.mesh).unit();
  return CGP::Curvature_potential::on_vertices(-unit * CGP::mean_curvature(input.mesh));
}

/// what is easier to have than a condition; any binormals exist, where no minimal surface is wanted
std::string easier_than(const CGP::Boundary_condition& condition, bool is_minimal)
{
  const bool has_binormals = condition.is_self_adjoint();
  if (condition.kind == CGP::Boundary_condition::Kind::positions)
    return "positions nearer to a conformal image, --position-weight 10";
  if (is_minimal)
    return std::string("conformal flow --boundary ") + (has_binormals ? "binormals" : "tangents") +
           " before, in small steps";
  const std::string gentler = "a gentler change of the directions";
  return has_binormals ? gentler
                       : "binormals instead of tangents, the tangents of a plane curve, " + gentler;
}

void boundary(const Boundary_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input = read_bounded_surface(options.spin.input, session);
  Transformed_surface surface = Transformed_surface::unchanged(input.mesh);
  surface.rho = potential(input, options);
  const Prescription_options& by = options.prescription;
  const CGP::Boundary_condition condition = prescribed_boundary(input, by);
  session.note_all(
      notes_of_repair_alike(input, {by.tangents_from, by.binormals_from, by.positions_from}));
  const double unit = User_frame(input.mesh).unit();
  const std::string easier = easier_than(condition, options.minimal);
  each_component(input, session, [&](const Component& component, Session& own) {
    require_boundary(component.input);
    Spin_problem problem{on_component(surface.rho, component, 1 / unit), options.spin.request,
                         options.minimal};
    problem.request.boundary = on_component(condition, input.mesh, component);
    surface.set(component, deform(component.input, problem, options.spin, easier, own));
  });
  write_result(input, surface, session, options.spin.lambda);
}

}  // namespace

Command boundary_command()
{
  return make_command<Boundary_options>("boundary", boundary_about, add_options, files, boundary);
}

}  // namespace conformal
