// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// With lengths bounded by 2, what do spins that are unknowns themselves (`Relaxed_scales`) realise
// of rho, and what do they cost, beside the search for the rho' whose eigenvector keeps to the
// bound (`Spin_transformation`)? Prints a line of JSON for each closed mesh of genus 0, potential
// and amplitude: seconds of the processor, lengths, and the change of curvature that is measured on
// the positions. The tip is that of the highest vertex, with a bump of .15 R.
//
// usage: benchmark_relaxed_spins NAME.off ...
#include <Conformal_geometry_processing/measure/Realised_curvature.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <cstdio>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>

#include "support/Off_file.h"
#include "support/Record.h"
#include "support/potentials.h"

namespace {

using namespace cgp_benchmark;
using Rho = CGP::Curvature_potential;

double now()
{
  return double(std::clock()) / CLOCKS_PER_SEC;
}

void add(const std::string& prefix, const CGP::Mesh_view& mesh, const CGP::Points& positions,
         const Rho& rho, Record& record)
{
  const Eigen::VectorXd areas = CGP::face_areas(mesh);
  record.add(prefix + "Q", areas.dot(CGP::quasi_conformal_errors(mesh, positions)) / areas.sum());
  if (const auto realised = CGP::realised_curvature(mesh, positions, rho))
    record.add(prefix + "share", realised->share)
        .add(prefix + "correlation", realised->correlation)
        .add(prefix + "distance", realised->distance)
        .add(prefix + "wrong_sign", realised->wrong_sign);
}

void add_relaxed(const CGP::Mesh_view& mesh, const Rho& rho,
                 const CGP::internal::Scale_control& control, Record& record)
{
  const double begin = now();
  CGP::internal::Dirac_system system(mesh);
  CGP::internal::Relaxed_scales scales(system, rho, control, {});
  const auto end = scales.run();
  const CGP::Poisson_reconstruction poisson(mesh, system.matrix().shared_pattern(),
                                            system.solver());
  const auto& lambda = scales.spins().lambda();
  const CGP::Points f = poisson.positions(CGP::transformed_edges(mesh, lambda));
  const auto measured = CGP::internal::measured_scales(lambda, system.areas(), control);
  const auto& costs = scales.spins().costs();
  record.add("seconds", now() - begin)
      .add("end", static_cast<int>(end))
      .add("factorizations", costs.factorizations)
      .add("solves", costs.solves)
      .add("scalar_factorizations", costs.scalar_factorizations)
      .add("scalar_solves", costs.scalar_solves)
      .add("low", measured.low)
      .add("high", measured.high);
  add("", mesh, f, rho, record);
}

void add_searched(const CGP::Mesh_view& mesh, const Rho& rho,
                  const CGP::internal::Scale_control& control, Record& record)
{
  const double begin = now();
  CGP::Spin_transformation_options options;
  options.scales = control;
  const CGP::Spin_result result = CGP::Spin_transformation(mesh, options).transform(rho);
  record.add("searched_seconds", now() - begin)
      .add("searched_verified", result.report ? 1 : 0)
      .add("searched_factorizations", result.report.factorizations)
      .add("searched_solves", result.report.solves);
  add("searched_", mesh, result.positions, rho, record);
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
  CGP::require_surface(mesh, "benchmark_relaxed_spins");
  CGP::require_closed(mesh, "benchmark_relaxed_spins");
  if (mesh.size_of_vertices() - mesh.size_of_edges() + mesh.size_of_faces() != 2)
    throw std::runtime_error("it has handles");
  CGP::internal::Scale_control control;
  control.bound = 2;
  for (const Potential& potential :
       {potentials[0], potentials[1], potentials[2], bump_at_tip(mesh)})
    for (const double amplitude : {.5, 1.5, 3.}) {
      const Rho rho = sampled(mesh, potential, amplitude);
      Record record;
      record.add("mesh", path.substr(path.find_last_of('/') + 1))
          .add("faces", mesh.size_of_faces())
          .add("potential", potential.name)
          .add("amplitude", amplitude);
      add_relaxed(mesh, rho, control, record);
      add_searched(mesh, rho, control, record);
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
