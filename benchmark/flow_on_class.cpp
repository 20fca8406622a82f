// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Compares the steps of the flow on the exact conformal class with the yardstick P, one scalar
/// Poisson problem by CHOLMOD on the same mesh. Prints a line of JSON for each mesh.
///
/// Usage: benchmark_flow_on_class MESH.off...
///
/// Meshes are closed and have the area 4 pi. Times are seconds of the processor.
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "support/Cholmod_poisson.h"
#include "support/Record.h"
#include "support/clock.h"
#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;

const int flow_steps = 20;

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
  record.add("faces", mesh.size_of_faces()).add("genus", CGP::topology(mesh).genus);
  record.add("poisson", P).add("steps", static_cast<int>(recorder.seconds.size()));
  record.add("seconds", end - begin).add("energy", flow.energy());
  record.add("construction", (constructed - begin) / P).add("finish", (end - recorder.begin) / P);
  record.add("cross_ratio", recorder.cross_ratio);
  add_steps(recorder.seconds, P, record);
}

void measure(const std::string& path)
{
  const CGP::Mesh_view mesh = make_mesh(path);
  const std::string name = path.substr(path.rfind('/') + 1);
  Record record;
  record.add("mesh", name.substr(0, name.rfind('.')));
  run_flow(mesh, record);
  record.print();
}

}  // namespace

int main(int argc, char* argv[])
{
  try {
    for (int i = 1; i < argc; ++i) measure(argv[i]);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_flow_on_class: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
