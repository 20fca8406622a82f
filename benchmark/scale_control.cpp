// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// With a bound of 2 on the factors of lengths, what is realised of rho, what does it cost in units
// of P, a scalar Poisson problem by CHOLMOD on the same mesh, and what happens without it? Prints a
// line of JSON for each closed mesh, potential and amplitude; with --bounds for each mesh,
// amplitude of six rings and bound; with --tips for each of two tips and amplitude of a bump there;
// with --sweep for each mesh, about 100 amplitudes of bands.
//
// usage: benchmark_scale_control [--bounds | --tips | --sweep] NAME.off ...
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "stage.h"
#include "support/Off_file.h"
#include "support/Record.h"
#include "support/potentials.h"

namespace {

using namespace cgp_benchmark;
using Rho = CGP::Curvature_potential;

CGP::Spin_result surface_of(const CGP::Mesh_view& mesh, const Rho& rho, std::optional<double> bound,
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
  return result;
}

CGP::Spin_report transformed(const CGP::Mesh_view& mesh, const Rho& rho,
                             std::optional<double> bound,
                             std::optional<double> mollification = std::nullopt)
{
  return surface_of(mesh, rho, bound, mollification).report;
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
      .add(prefix + "tip_low", report.scales.tip_low)
      .add(prefix + "tip_high", report.scales.tip_high)
      .add(prefix + "Q", report.conformality.quasi_conformal.mean)
      .add(prefix + "collapsed", report.conformality.scale.collapsed_share)
      .add(prefix + "factorizations", report.factorizations)
      .add(prefix + "solves", report.solves);
  if (const auto& realised = report.realised_curvature)
    record.add(prefix + "distance", realised->distance)
        .add(prefix + "agreement", realised->agreement());
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

CGP::Mesh_view closed_surface(const std::string& path)
{
  const CGP::Mesh_view mesh = normalized(read_off(path));
  CGP::require_surface(mesh, "benchmark_scale_control");
  CGP::require_closed(mesh, "benchmark_scale_control");
  return mesh;
}

/// a vertex far from the centre, and one far from that
std::vector<int> tips(const CGP::Mesh_view& mesh)
{
  Eigen::Index first = 0, second = 0;
  mesh.positions().colwise().squaredNorm().maxCoeff(&first);
  (mesh.positions().colwise() - mesh.positions().col(first))
      .colwise()
      .squaredNorm()
      .maxCoeff(&second);
  return {static_cast<int>(first), static_cast<int>(second)};
}

// The size is the factor of lengths at the tip.
void survey_tips(const std::string& path)
{
  const CGP::Mesh_view mesh = closed_surface(path);
  for (const int tip : tips(mesh)) {
    const Potential bump = {"bump", [&](const Eigen::Vector3d& p, double) {
                              return std::exp(-(p - mesh.position(tip)).squaredNorm() / .045);
                            }};
    for (const double amplitude : {.25, .5, 1., 2., 3.}) {
      const CGP::Spin_result result = surface_of(mesh, sampled(mesh, bump, amplitude), 2);
      Record record;
      record.add("mesh", name_of(path))
          .add("faces", mesh.size_of_faces())
          .add("tip", tip)
          .add("amplitude", amplitude)
          .add("size", squared_norm(result.lambda[tip]));
      add(result.report, "", record);
      record.print();
    }
  }
}

/// the largest step relative to the median of its ten neighbours
double largest_jump(const std::vector<double>& steps)
{
  double largest = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const std::size_t begin = std::min(i < 5 ? 0 : i - 5, steps.size() - 11);
    std::vector<double> near(steps.begin() + static_cast<std::ptrdiff_t>(begin),
                             steps.begin() + static_cast<std::ptrdiff_t>(begin + 11));
    std::nth_element(near.begin(), near.begin() + 5, near.end());
    largest = std::max(largest, steps[i] / near[5]);
  }
  return largest;
}

// Steps are distances of surfaces by the diagonal; lengths retreat where their range, 2 at the
// bound of most or of tips, becomes smaller, which is told as a share of it.
void sweep(const std::string& path)
{
  const CGP::Mesh_view mesh = closed_surface(path);
  std::vector<double> steps;
  double widest = 1, retreat = 0, least = 1;
  CGP::Points before = mesh.positions();
  for (int i = 1; i <= 100; ++i) {
    const CGP::Spin_result r = surface_of(mesh, sampled(mesh, potentials[0], .04 * i), 2);
    const double range = std::pow(2, r.report.scales.excess());
    steps.push_back(CGP::align(r.positions, before).rms);
    retreat = std::max(retreat, 1 - range / widest);
    widest = std::max(widest, range);
    if (r.report.realised_curvature)
      least = std::min(least, r.report.realised_curvature->agreement());
    before = r.positions;
  }
  Record record;
  record.add("mesh", name_of(path))
      .add("faces", mesh.size_of_faces())
      .add("jump", largest_jump(steps))
      .add("step", *std::max_element(steps.begin(), steps.end()))
      .add("retreat", retreat)
      .add("least_agreement", least);
  record.print();
}

void survey(const std::string& path)
{
  const CGP::Mesh_view mesh = closed_surface(path);
  const double poisson = seconds_of_scalar_poisson(mesh);
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
      const double begin = cpu_seconds();
      CGP::Spin_report report = transformed(mesh, rho, bound);
      record.add("P", (cpu_seconds() - begin) / poisson);
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
  const std::map<std::string, void (*)(const std::string&)> modes = {
      {"--bounds", compare_bounds}, {"--tips", survey_tips}, {"--sweep", sweep}};
  const auto mode = modes.find(argc > 1 ? argv[1] : "");
  const bool is_survey = mode == modes.end();
  for (int k = is_survey ? 1 : 2; k < argc; ++k) try {
      (is_survey ? survey : mode->second)(argv[k]);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: left out: %s\n", argv[k], e.what());
    }
}
