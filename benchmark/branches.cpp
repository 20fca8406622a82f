// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Is the eigenpair that solve_dirac_equation() finds the one that small steps in rho lead to, and
// does it depend on a constant added to rho? Prints a line of JSON for each mesh, potential and
// amplitude.
//
// usage: benchmark_branches NAME.off ...
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include "support/Off_file.h"
#include "support/Record.h"
#include "support/potentials.h"

namespace {

using namespace cgp_benchmark;
using CGP::Quaternion;
using CGP::Quaternion_vector;
using System = CGP::internal::Dirac_system;
using Rho = CGP::Curvature_potential;

Rho scaled(const Rho& rho, double t, double sigma)
{
  return {rho.on, (t * rho.values.array() + sigma).matrix()};
}

/// Small steps: each factors X with the shift at the last eigenvalue, and takes the smallest
/// eigenvector near the last one.
struct Path {
  Quaternion_vector<double> lambda;
  double gamma = 0, least_overlap = 1;
};

void advance(System& system, const Rho& rho, double t, Path& path)
{
  const Quaternion_vector<double> before = path.lambda;
  CGP::internal::Dirac_evidence::Seconds seconds;
  CGP::Eigensolver_options options;
  options.tolerance = 1e-8;
  options.scale = std::sqrt(system.unit());
  for (int pass = 0; pass < 3; ++pass) {
    const Rho shifted = scaled(rho, t, path.gamma);
    system.set_potential(shifted, seconds);
    const auto found =
        CGP::Lobpcg_eigensolver_traits()(system.matrix(), system.areas(), system.solver(),
                                         CGP::Block<Quaternion<double>>(path.lambda), options);
    path.lambda = found.vectors.col(0);
    path.gamma += CGP::dirac_quotient(system.surface(), shifted, path.lambda);
  }
  path.least_overlap = std::min(path.least_overlap, system.overlap(before, path.lambda));
}

Path small_steps(System& system, const Rho& rho, int steps)
{
  Path path;
  path.lambda = Quaternion_vector<double>::Constant(system.areas().size(), {1, 0, 0, 0});
  for (int k = 1; k <= steps; ++k) advance(system, rho, double(k) / steps, path);
  return path;
}

void compare(System& system, const Rho& rho, Record& record)
{
  const Path path = small_steps(system, rho, 24);
  CGP::Dirac_options options;
  options.tolerance = 1e-10;
  const auto s = CGP::solve_dirac_equation(system, rho);
  const auto exact = CGP::solve_dirac_equation(system, rho, options);
  const auto shifted = CGP::solve_dirac_equation(system, scaled(rho, 1, 1), options);
  record.add("least_overlap", path.least_overlap)
      .add("agreement", system.overlap(path.lambda, s.lambda))
      .add("converged", s.converged ? 1 : 0)
      .add("factorizations", s.factorizations)
      .add("solves", s.solves)
      .add("gamma", s.eigenvalue)
      .add("gamma_of_path", path.gamma)
      .add("dirac_residual", s.dirac_residual)
      .add("branch_gap", s.branch_gap)
      .add("shift_converged", exact.converged && shifted.converged ? 1 : 0)
      .add("shift_changes",
           CGP::components(Quaternion_vector<double>(exact.lambda - shifted.lambda))
               .cwiseAbs()
               .maxCoeff());
}

void survey(const std::string& path)
{
  const CGP::Mesh_view mesh = normalized(read_off(path));
  CGP::require_surface(mesh, "benchmark_branches");
  CGP::require_closed(mesh, "benchmark_branches");
  CGP::require_genus_zero(mesh, "benchmark_branches");
  System system(mesh);
  for (const Potential& potential : potentials)
    for (const double amplitude : {.3, .6, 1., 1.5, 2.}) {
      Record record;
      record.add("mesh", path.substr(path.find_last_of('/') + 1))
          .add("faces", mesh.size_of_faces())
          .add("potential", potential.name)
          .add("amplitude", amplitude);
      compare(system, sampled(mesh, potential, amplitude), record);
      record.print();
    }
}

}  // namespace

int main(int argc, char** argv)
{
  for (int k = 1; k < argc; ++k) try {
      survey(argv[k]);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: left out: %s\n", argv[k], e.what());
    }
}
