// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "option_groups.h"

#include "conformal/input/rho.h"
#include "conformal/process/Failure.h"
#include "conformal/process/Progress.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"
#include "conformal/report/certificate.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/flow/fair_region.h>

#include <cmath>
#include <limits>
#include <vector>

namespace conformal {
namespace {

const char* const fair_about =
    "Replaces a region of a surface by the smoothest one with the same rim and normals, with\n"
    "the least Willmore energy. The region is where a formula or a vertex property is positive.\n"
    "All else stays as it is, to the bit. By default the region stays in its conformal class, so\n"
    "that textures and the quality of triangles survive; --outline looks at nothing but the rim,\n"
    "as is right for a hole that was filled with any triangles.\n"
    "The formula has x, y, z (the middle of the bounding box is 0, its diagonal 2) and the normal\n"
    "nx, ny, nz, as that of `conformal spin --rho-expression`.\n"
    "The output has the vertex property quality (quasi-conformal error, 1 is perfect).\n"
    "A result that does not verify is not written; one that is not yet as smooth as possible is.\n"
    "Both exit with 1.\n"
    "Example, which takes an ear off a bear: conformal fair bear.off --outline\n"
    "  --region-expression 'min(y-.4,-x-.05)' -o bear_faired.ply";

struct Fair_options {
  std::string input, expression, property;
  bool outline = false;
  int steps = CGP::internal::Fairing_options().max_steps;
  bool force = false;
  CGP::Spin_report::Limits limits;
};

void add_options(CLI::App& command, Fair_options& fair, Common_options& common)
{
  add_input(command, fair.input);
  auto* const region = command.add_option_group("region");
  region->add_option("--region-expression", fair.expression,
                     "formula that is positive at the vertices that may move");
  region->add_option("--region-property", fair.property, "vertex property with these numbers");
  region->require_option(1);
  command.add_flag("--outline", fair.outline, "does not keep the conformal class of the region");
  command.add_option("--steps", fair.steps, "how many steps at most")
      ->check(above_zero)
      ->capture_default_str();
  add_transformation(command, common);
  add_map_limits(command, fair.limits, fair.force);
}

Files files(const Fair_options& fair)
{
  return {{"the input", fair.input, Named_file::Role::replaceable}};
}

/// the faces at the vertices that may move
std::vector<char> faces_around(const CGP::Mesh_view& mesh, const Eigen::VectorXd& numbers)
{
  std::vector<char> are_in_region;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    are_in_region.push_back(numbers[v[0]] > 0 || numbers[v[1]] > 0 || numbers[v[2]] > 0);
  }
  return are_in_region;
}

CGP::internal::Fairing_result fair_watched(const CGP::Mesh_view& mesh,
                                           const std::vector<char>& is_in_region,
                                           const Fair_options& options, const Session& session)
{
  CGP::internal::Fairing_options fairing;
  fairing.exact_conformal_class = !options.outline;
  fairing.max_steps = options.steps;
  Progress progress = session.progress();
  int step = 0;
  const auto go_further = [&] {
    ++step;
    progress.show(
        {"step", static_cast<double>(step) / options.steps, "step " + std::to_string(step), step});
    return signal_received() == 0;
  };
  auto result = fair_region(mesh, is_in_region, fairing, "conformal fair", go_further);
  throw_if_interrupted();
  return result;
}

void tell_fairing(const CGP::internal::Fairing_report& fairing, int faces, Report& report)
{
  const double degree = std::acos(-1.) / 180;
  report.tell("result/free_vertices", "vertices that may move", fairing.free_vertices);
  report.tell("result/steps", "steps", fairing.steps);
  report.tell("result/energy/before", "Willmore energy of the region before",
              fairing.initial_energy);
  report.tell("result/energy/after", "Willmore energy of the region after", fairing.energy);
  report.tell("result/normal_jump/before", "largest angle of normals at the rim before (degrees)",
              fairing.initial_normal_jump.max / degree, 3);
  report.tell("result/normal_jump/after", "largest angle of normals at the rim after (degrees)",
              fairing.normal_jump.max / degree, 3);
  tell_conformality(fairing.conformality, faces, report);
}

/// Of an outline no map is asked for that would be conformal; it must not be folded.
CGP::Spin_report::Limits limits_of(const Fair_options& options)
{
  CGP::Spin_report::Limits limits = options.limits;
  if (options.outline) limits.map.quasi_conformal = std::numeric_limits<double>::infinity();
  return limits;
}

void fair(const Fair_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input = read_suitable_surface(options.input, session);
  const Eigen::VectorXd numbers =
      vertex_numbers(input, "--region-expression", options.expression, options.property);
  if (!(numbers.maxCoeff() > 0))
    throw unsuitable(options.input, "no vertex is in the region, wanted some where it is positive");
  Transformed_surface surface = Transformed_surface::unchanged(input.mesh);
  each_component(input, session, [&](const Component& component, Session& own) {
    const CGP::Mesh_view& mesh = component.input.mesh;
    const Eigen::VectorXd here = numbers(component.vertices);
    if (!(here.maxCoeff() > 0)) {  // it stays as it is
      own.conclude(judge({mesh.positions()}, options.limits, ""), On_fault::refuse);
      return;
    }
    const auto result = fair_watched(mesh, faces_around(mesh, here), options, own);
    tell_fairing(result.report, mesh.size_of_faces(), own.report());
    Evidence evidence{result.positions};
    evidence.map = result.report.conformality;
    Verdict verdict = judge(evidence, limits_of(options), "a smaller region, or --outline");
    const bool is_better =
        verdict.is_verified() && result.report.energy < result.report.initial_energy;
    if (verdict.is_verified() && !result.report)
      verdict.fault = result.report.message + "; try: more --steps, a finer mesh";
    const On_fault write = is_better ? On_fault::fail_in_the_end : On_fault::refuse;
    own.conclude(verdict, options.force ? On_fault::force : write);
    surface.positions(Eigen::indexing::all, component.vertices) = result.positions;
  });
  write_result(input, surface, session);
}

}  // namespace

Command fair_command()
{
  return make_command<Fair_options>("fair", fair_about, add_options, files, fair);
}

}  // namespace conformal
