// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "option_groups.h"

#include "conformal/input/rho.h"
#include "conformal/input/targets.h"
#include "conformal/process/text.h"
#include "conformal/report/certificate.h"
#include "conformal/report/target_report.h"
#include "conformal/transform/Search_watch.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/spin/Conformal_deformation.h>

#include <functional>
#include <string>
#include <vector>

namespace conformal {
namespace {

const char* const deform_about =
    "Deforms a surface conformally so that vertices and regions move to given places.\n"
    "TARGETS is a JSON file in the units of the mesh, with vertices by their numbers from 0:\n"
    "  {\"targets\": [{\"vertex\": 12, \"to\": [0, 1, 0]},\n"
    "               {\"vertex\": 40, \"move\": [0, 0, 0]},\n"
    "               {\"box\": [[0, 0, 0], [1, 1, 1]], \"move\": [0, 1, 0], \"turn\": [0, 0, 1, "
    "30]}]}\n"
    "The vertices in a box (or \"vertices\": [1, 2, 3]) are a region: its centre and its axes of\n"
    "inertia move, and turn about the axis through the centre by so many degrees. What has no\n"
    "target is free: hold parts by targets where they are. Moving, turning and scaling the whole\n"
    "costs nothing, so one or two targets do only that. The targets are met exactly, with the\n"
    "least change rho of mean curvature. The output has the vertex properties quality\n"
    "(quasi-conformal error, 1 is perfect) and rho.\n"
    "Targets beyond reach are approached as far as the surface verifies and no face is flipped;\n"
    "--limit realised_share tells how much of the way is enough.\n"
    "With a region, nothing else changes, to the bit: a formula as that of `conformal fair`, or a\n"
    "vertex property. Where it is 1 or more the surface follows the targets, where it is 0 or "
    "less\n"
    "it stays, and between them, in the collar, the deformation fades out. Of a region in several\n"
    "parts, the one with the targets moves. The collar gives as far as targets need it to.\n"
    "A result that does not verify is not written, and the exit code is 1.\n"
    "Example: conformal deform bear.off --targets lift_a_leg.json -o bear_deformed.ply";

struct Deform_options {
  Deform_options()
  {
    request.surface.limits.realised_share = 1;
    request.surface.scales.bound = CGP::internal::default_scale_bound;
  }

  std::string input, targets;
  std::string expression, property;  ///< of the region; all of the surface, if both are empty
  std::string lambda;                ///< the name of the vertex properties, none if empty
  CGP::internal::Conformal_deformation_options request;
  bool force = false;
};

void add_options(CLI::App& command, Deform_options& deform, Common_options& common)
{
  add_input(command, deform.input);
  command.add_option("--targets", deform.targets, "JSON file with the targets")->required();
  auto* const region = command.add_option_group("region");
  region->add_option("--region-expression", deform.expression,
                     "formula of the weights in the region, 1: moves, 0: stays");
  region->add_option("--region-property", deform.property, "vertex property with these numbers");
  region->require_option(0, 1);
  add_max_scale(command, deform.request.surface.scales.bound);
  command
      .add_option("--weight", deform.request.position_weight,
                  "weight of the distances from the targets against rho; without it they are zero")
      ->check(above_zero);
  add_mollification(command, deform.request.surface.mollification);
  add_lambda(command, deform.lambda);
  add_transformation(command, common);
  add_limits(command, deform.request.surface.limits, deform.force);
}

Files files(const Deform_options& deform)
{
  return {{"the input", deform.input, Named_file::Role::replaceable},
          {"the targets", deform.targets}};
}

/// tells how many vertices of a region moved, and how many did not
void tell_region(const Eigen::VectorXd& wanted, const Eigen::VectorXd& moved, Session& session)
{
  if (wanted.size() == 0) return;
  const Eigen::Index stay = (wanted.array() != moved.array()).count();
  session.report().set("result/region/vertices", static_cast<int>((moved.array() > 0).count()));
  if (stay > 0)
    session.note(std::to_string(stay) +
                 " vertices of the region stay, as the part that they are in has no target");
}

/// what came of it
struct Deformation_solution : CGP::Spin_result {
  CGP::Curvature_potential rho;  ///< that was found, in 1/length of the mesh, on vertices
};

Deformation_solution deform_surface(const Surface_input& input,
                                    const std::vector<CGP::internal::Control_point>& points,
                                    const Deform_options& options, Session& session)
{
  const CGP::internal::Conformal_deformation_options& request = options.request;
  Search_watch watch(session, request.surface.dirac.tolerance);
  CGP::internal::Conformal_deformation deformation(input.mesh, request, "deform");
  Deformation_solution solution{deformation.deform(points, std::ref(watch)),
                                deformation.potential()};
  watch.end(solution.report);
  session.begin_stage();
  const CGP::Spin_report& report = solution.report;
  tell_region(request.region, deformation.region(), session);
  tell_targets(report, points.size(), session.report());
  if (report.collar) tell_collar(*report.collar, session.report());
  tell_certificate(report, input.mesh.size_of_faces(), session.outcome());
  const Evidence evidence{
      solution.positions, report, {}, fault_of_targets(report, options.request.surface.limits)};
  const bool can_force = options.force && solution.positions.cols() > 0;
  session.conclude(judge(evidence, options.request.surface.limits, "nearer targets"),
                   on_fault(can_force));
  if (report.reached < 1)
    session.note("only " + text_of(100 * report.reached, 3) + " % of the way to the targets");
  return solution;
}

/// between 0 and 1 for each vertex; empty if there is no region
Eigen::VectorXd region_weights(const Surface_input& input, const Deform_options& options)
{
  return vertex_numbers(input, "--region-expression", options.expression, options.property)
      .cwiseMax(0.)
      .cwiseMin(1.);
}

void deform(const Deform_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input = read_suitable_surface(
      options.input, session, flat_faces(options.request.surface.mollification));
  const std::vector<Target> targets = read_targets(input, options.targets);
  const Eigen::VectorXd region = region_weights(input, options);
  const double unit = User_frame(input.mesh).unit();
  Transformed_surface surface = Transformed_surface::unchanged(input.mesh);
  surface.rho =
      CGP::Curvature_potential::on_vertices(Eigen::VectorXd::Zero(input.mesh.size_of_vertices()));
  each_component(input, session, [&](const Component& component, Session& own) {
    const auto points = control_points(targets, component.input.mesh, component.vertices);
    if (points.empty()) {  // it stays where it is
      own.conclude(judge({component.input.mesh.positions()}, options.request.surface.limits, ""),
                   On_fault::refuse);
      return;
    }
    Deform_options of_component = options;
    if (region.size() > 0) of_component.request.region = region(component.vertices);
    const Deformation_solution solution =
        deform_surface(component.input, points, of_component, own);
    surface.set(component, solution);
    surface.rho.values(component.vertices) = unit * solution.rho.values;
  });
  write_result(input, surface, session, options.lambda);
}

}  // namespace

Command deform_command()
{
  return make_command<Deform_options>("deform", deform_about, add_options, files, deform);
}

}  // namespace conformal
