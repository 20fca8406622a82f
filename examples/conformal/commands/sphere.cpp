// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "option_groups.h"

#include "conformal/input/Surface_input.h"
#include "conformal/process/Failure.h"
#include "conformal/process/interruption.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/surfaces/spheres.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <cmath>

namespace conformal {
namespace {

const char* const sphere_about =
    "Makes a Dirac sphere: a conformal image of the unit sphere with Willmore energy 4 pi "
    "kappa^2,\n"
    "whose curvature half-density is a multiple of its length density, from a spherical spinor.\n"
    "For s = 0 it is immersed; for 0 < s < |kappa| it has branch points at both poles, where the\n"
    "few faces around have any energy, which need not fall with --level.\n"
    "Example: conformal sphere --kappa -3 --s 1 --level 6 -o dirac_sphere.ply";

/// what `conformal sphere` takes
struct Sphere_options {
  int kappa = -2, s = 0, level = 5;
  bool force = false;
  CGP::Spin_report::Limits limits;
};

void add_options(CLI::App& command, Sphere_options& options, Common_options& common)
{
  // The work is a loop over kappa for each vertex; no mesh here could resolve more.
  command
      .add_option("--kappa", options.kappa,
                  "from -1000 to 1000, but not zero; the eigenvalue is -kappa - 1")
      ->check(CLI::Range(-1000, 1000))
      ->capture_default_str();
  command.add_option("--s", options.s, "from -|kappa| to |kappa| - 1; -s - 1 gives the same as s")
      ->capture_default_str();
  command.add_option("--level", options.level, "how fine: 20 * 4^level triangles, at most level 9")
      ->check(CLI::Range(0, 9))
      ->capture_default_str();
  add_map_limits(command, options.limits, options.force);
  add_mesh_output(command, common)->required();
}

Files files(const Sphere_options&)
{
  return {};
}

CGP::Spin_result dirac_sphere(const CGP::Mesh_view& mesh, const Sphere_options& options)
{
  try {
    CGP::require_spherical_spinor(options.kappa, options.s, "sphere");
  } catch (const CGP::Precondition_error& error) {
    throw Failure(Exit_code::usage, error.message());
  }
  return CGP::spin_to_dirac_sphere(mesh, options.kappa, options.s, "sphere");
}

void tell(const CGP::Spin_result& result, const CGP::Mesh_view& mesh, Report& report)
{
  const double energy = CGP::willmore_energy(CGP::Mesh_view(result.positions, mesh.corners()));
  const auto& Q = result.report.conformality.quasi_conformal;
  report.tell("result/eigenvalue", "eigenvalue", result.report.eigenvalue);
  report.tell("result/willmore_energy", "Willmore energy, in 4 pi", energy / (4 * std::acos(-1.)));
  report.tell("result/closure_residual", "closure, relative", result.report.closure_residual);
  report.tell("result/quasi_conformal/mean", "quasi-conformal error, mean", Q.mean);
  report.tell("result/quasi_conformal/max", "quasi-conformal error, greatest", Q.max);
  report.tell("result/min_spin_ratio", "smallest |lambda| / greatest",
              result.report.min_spin_ratio);
}

/// \pre the spinor is exact: its residuals are those of the mesh
void sphere(const Sphere_options& options, Session& session)
{
  require_writable(session.options().output);
  const Surface_input input = as_input(CGP::geodesic_sphere(1 << options.level));
  const CGP::Spin_result result = dirac_sphere(input.mesh, options);
  throw_if_interrupted();
  session.end_stage("solve");
  tell(result, input.mesh, session.report());
  const Evidence evidence{result.positions, {}, result.report.conformality};
  session.conclude(judge(evidence, options.limits, "another --level"), on_fault(options.force));
  write_result(input, {result.positions}, session);
}

}  // namespace

Command sphere_command()
{
  return make_command<Sphere_options>("sphere", sphere_about, add_options, files, sphere);
}

}  // namespace conformal
