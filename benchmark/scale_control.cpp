// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// How much of rho is kept with a bound of 2 on the factors of lengths, what that costs, and what
// happens without it? Prints a line of JSON for each closed mesh, potential and amplitude; with
// --bounds for each mesh, amplitude of six rings and bound.
//
// usage: benchmark_scale_control [--bounds] NAME.off ...
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <cstdio>
#include <exception>
#include <optional>
#include <string>

#include "support/Off_file.h"
#include "support/Record.h"
#include "support/potentials.h"

namespace {

using namespace cgp_benchmark;
using Rho = CGP::Curvature_potential;

CGP::Spin_report transformed(const CGP::Mesh_view& mesh, const Rho& rho,
                             std::optional<double> bound,
                             std::optional<double> mollification = std::nullopt)
{
  CGP::Spin_transformation_options options;
  options.scales.bound = bound;
  options.mollification = mollification;
  CGP::Spin_transformation transformation(mesh, options);
  CGP::Spin_result result = transformation.transform(rho);
  if (!bound)
    result.report.scales =
        CGP::internal::measured_scales(result.lambda, CGP::vertex_areas(mesh), options.scales);
  return result.report;
}

/// the reason of the verdict; of a map, which of its limits is exceeded
const char* fault_of(const CGP::Spin_report& report)
{
  const CGP::Spin_report::Fault fault = report.fault();
  if (fault != CGP::Spin_report::Fault::map) return to_string(fault);
  return to_string(report.conformality.fault(report.limits.map));
}

void add(const CGP::Spin_report& report, const std::string& prefix, Record& record)
{
  record.add(prefix + "verified", report ? 1 : 0)
      .add(prefix + "fault", fault_of(report))
      .add(prefix + "low", report.scales.low)
      .add(prefix + "high", report.scales.high)
      .add(prefix + "Q", report.conformality.quasi_conformal.mean)
      .add(prefix + "collapsed", report.conformality.scale.collapsed_share)
      .add(prefix + "factorizations", report.factorizations)
      .add(prefix + "solves", report.solves);
}

std::string name_of(const std::string& path)
{
  return path.substr(path.find_last_of('/') + 1);
}

void compare_bounds(const std::string& path)
{
  const CGP::Mesh_view mesh = normalized(read_off(path));
  CGP::require_surface(mesh, "benchmark_scale_control");
  const CGP::internal::Topology topology = CGP::topology(mesh);
  const std::optional<double> none;
  for (const double amplitude : {1.2, 3.})
    for (const std::optional<double>& bound : {none, {2}, {1.5}, {1.3}, {1.15}}) {
      const CGP::Spin_report report =
          transformed(mesh, sampled(mesh, potentials[1], amplitude), bound);
      Record record;
      record.add("mesh", name_of(path))
          .add("faces", mesh.size_of_faces())
          .add("genus", topology.genus)
          .add("loops", topology.boundary_loops)
          .add("amplitude", amplitude)
          .add("bound", bound.value_or(0));
      add(report, "", record);
      record.add("Q_max", report.conformality.quasi_conformal.max)
          .add("least", report.conformality.scale.min_scale)
          .add("most", report.conformality.scale.max_scale)
          .add("kept_norm", bound ? report.scales.kept_norm : 1)
          .add("kept_correlation", bound ? report.scales.kept_correlation : 1);
      record.print();
    }
}

void survey(const std::string& path)
{
  const CGP::Mesh_view mesh = normalized(read_off(path));
  CGP::require_surface(mesh, "benchmark_scale_control");
  CGP::require_closed(mesh, "benchmark_scale_control");
  const int chi = mesh.size_of_vertices() - mesh.size_of_edges() + mesh.size_of_faces();
  const double bound = 2;
  for (const Potential& potential : potentials)
    for (const double amplitude : {.75, 1.5, 3.}) {
      const Rho rho = sampled(mesh, potential, amplitude);
      Record record;
      record.add("mesh", name_of(path))
          .add("faces", mesh.size_of_faces())
          .add("genus", 1 - chi / 2)
          .add("potential", potential.name)
          .add("amplitude", amplitude);
      add(transformed(mesh, rho, std::nullopt), "plain_", record);
      CGP::Spin_report report = transformed(mesh, rho, bound);
      const bool is_retried = !report;
      if (is_retried) report = transformed(mesh, rho, bound, 1e-6);
      add(report, "", record);
      record.add("mollified", is_retried ? 1 : 0)
          .add("weight", report.scales.weight)
          .add("kept_norm", report.scales.kept_norm)
          .add("kept_correlation", report.scales.kept_correlation)
          .add("closure", report.closure_residual)
          .add("period_defect", report.period_defect);
      record.print();
    }
}

}  // namespace

int main(int argc, char** argv)
{
  const bool compares = argc > 1 && std::string(argv[1]) == "--bounds";
  for (int k = compares ? 2 : 1; k < argc; ++k) try {
      (compares ? compare_bounds : survey)(argv[k]);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: left out: %s\n", argv[k], e.what());
    }
}
