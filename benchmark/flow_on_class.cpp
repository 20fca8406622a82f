// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Compares the flow on the exact conformal class with the modified mean curvature flow [KSBC12] on
/// the same connectivity, and its steps with the yardstick P, one scalar Poisson problem by CHOLMOD
/// on that mesh. Prints a line of JSON for each mesh.
///
/// Usage: benchmark_flow_on_class MESH.off...
///
/// Meshes are closed and have the area 4 pi. Times are seconds of the processor. The modified mean
/// curvature flow goes to spheres only: it runs on meshes of genus 0, to its end.
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "fairing/modified_mean_curvature.h"
#include "fairing/unit_frame.h"
#include "support/Cholmod_poisson.h"
#include "support/Record.h"
#include "support/clock.h"
#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;

const int flow_steps = 20;
const double mean_curvature_step = .1;
const int mean_curvature_steps = 400;  // at most
const double arrived = 1e-6;           // of the radius: no vertex moves further

/// the seconds of every step, and how far it is from the class
struct Recorder : CGP::Flow_visitor {
  std::vector<double> seconds;
  double cross_ratio = 0;
  double begin = cpu_seconds();

  void on_flow_begin(const CGP::Mesh_view&, double) { begin = cpu_seconds(); }

  void on_step_end(const CGP::Flow_step_report& step, const CGP::Mesh_view&)
  {
    const double end = cpu_seconds();
    seconds.push_back(end - begin);
    cross_ratio = std::max(cross_ratio, step.length_cross_ratio);
    begin = end;
  }
};

double median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// in P: the median and the worst of all steps, and the median of the last five
void add_steps(const std::vector<double>& seconds, double P, Record& record)
{
  if (seconds.empty()) return;
  const auto late = std::min<std::ptrdiff_t>(5, static_cast<std::ptrdiff_t>(seconds.size()));
  record.add("step", median(seconds) / P);
  record.add("worst_step", *std::max_element(seconds.begin(), seconds.end()) / P);
  record.add("late_step", median({seconds.end() - late, seconds.end()}) / P);
}

void run_flow(const CGP::Mesh_view& mesh, Record& record)
{
  Poisson_seconds poisson;
  CGP::Flow_options options;
  options.max_steps = flow_steps;
  const double begin = cpu_seconds();
  CGP::Conformal_willmore_flow flow(mesh, options);
  const double constructed = cpu_seconds();
  Recorder recorder;
  (void)flow.run(recorder);
  const double end = cpu_seconds();
  for (int i = 0; i < 5; ++i) poisson.measure(flow.initial_mesh());
  const double P = poisson.total;
  record.add("poisson", P).add("steps", static_cast<int>(recorder.seconds.size()));
  record.add("construction", (constructed - begin) / P).add("finish", (end - recorder.begin) / P);
  record.add("cross_ratio", recorder.cross_ratio);
  add_steps(recorder.seconds, P, record);
}

/// the surface at which the flow arrives
CGP::Points mean_curvature_limit(const CGP::Mesh_view& mesh)
{
  Modified_mean_curvature flow(mesh, mean_curvature_step);
  for (int step = 0; step < mean_curvature_steps; ++step) {
    const CGP::Points before = flow.mesh().positions();
    flow.step();
    flow.set_positions(positions_in_unit_frame(flow.mesh()));
    if ((flow.mesh().positions() - before).cwiseAbs().maxCoeff() < arrived) break;
  }
  return flow.mesh().positions();
}

void run_mean_curvature(const CGP::Mesh_view& mesh, Record& record)
{
  const CGP::Points positions = mean_curvature_limit(mesh);
  const CGP::Conformality map =
      CGP::conformality(mesh, positions, CGP::neighbourhood_normals(mesh, positions));
  record.add("energy", CGP::willmore_energy(CGP::Mesh_view(positions, mesh.corners())));
  record.add("q_mean", map.quasi_conformal.mean).add("q_max", map.quasi_conformal.max);
  record.add("cmcf_cross_ratio", map.length_cross_ratio.max).add("flips", map.flipped_faces);
}

void compare(const std::string& path)
{
  const CGP::Mesh_view mesh = make_mesh(path);
  const std::string name = path.substr(path.rfind('/') + 1);
  Record record;
  record.add("mesh", name.substr(0, name.rfind('.')));
  run_flow(mesh, record);
  if (CGP::topology(mesh).is_sphere())
    run_mean_curvature(CGP::internal::simple_delaunay(mesh), record);
  record.print();
}

}  // namespace

int main(int argc, char* argv[])
{
  try {
    for (int i = 1; i < argc; ++i) compare(argv[i]);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_flow_on_class: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
