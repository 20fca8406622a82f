// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// With lengths bounded by 2, what does a transformation realise of rho, and what does it cost?
// Prints a line of JSON for each mesh, potential and amplitude: seconds of the processor in units
// of P, a scalar Poisson problem by CHOLMOD on the same mesh; lengths; and the change of curvature
// that is measured on the positions. The tip is that of the highest vertex, with a bump of .15 R.
// `benchmark/measure_bounded` writes doc/bounded.md from it.
//
// usage: benchmark_bounded NAME.off ...
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <cstdio>
#include <exception>
#include <string>

#include "stage.h"
#include "support/Off_file.h"
#include "support/Record.h"
#include "support/potentials.h"

namespace {

using namespace cgp_benchmark;
using Rho = CGP::Curvature_potential;

void add_bounded(const CGP::Mesh_view& mesh, const Rho& rho, double poisson, Record& record)
{
  const double begin = cpu_seconds();
  CGP::Spin_transformation_options options;
  options.scales.bound = 2;
  CGP::Spin_transformation transformation(mesh, options);
  const CGP::Spin_report r = transformation.transform(rho).report;
  record.add("P", (cpu_seconds() - begin) / poisson)
      .add("verified", r ? 1 : 0)
      .add("factorizations", r.factorizations)
      .add("solves", r.solves)
      .add("low", r.scales.low)
      .add("high", r.scales.high)
      .add("weight", r.scales.weight)
      .add("closure", r.closure_residual)
      .add("Q", r.conformality.quasi_conformal.mean);
  if (const auto& realised = r.realised_curvature)
    record.add("share", realised->share)
        .add("correlation", realised->correlation)
        .add("distance", realised->distance)
        .add("wrong_sign", realised->wrong_sign);
}

Potential bump_at_tip(const CGP::Mesh_view& mesh)
{
  Eigen::Index top = 0;
  mesh.positions().row(1).maxCoeff(&top);
  return {"tip", [tip = Eigen::Vector3d(mesh.positions().col(top))](const auto& p, double) {
            return std::exp(-(p - tip).squaredNorm() / (2 * .15 * .15));
          }};
}

void survey(const std::string& path)
{
  const CGP::Mesh_view mesh = normalized(read_off(path));
  CGP::require_surface(mesh, "benchmark_bounded");
  CGP::require_closed(mesh, "benchmark_bounded");
  const double poisson = seconds_of_scalar_poisson(mesh);
  for (const Potential& potential :
       {potentials[0], potentials[1], potentials[2], bump_at_tip(mesh)})
    for (const double amplitude : {.5, 1.5, 3.}) {
      Record record;
      record.add("mesh", path.substr(path.find_last_of('/') + 1))
          .add("faces", mesh.size_of_faces())
          .add("euler", mesh.size_of_vertices() - mesh.size_of_edges() + mesh.size_of_faces())
          .add("potential", potential.name)
          .add("amplitude", amplitude);
      add_bounded(mesh, sampled(mesh, potential, amplitude), poisson, record);
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
