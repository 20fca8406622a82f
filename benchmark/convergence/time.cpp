// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/distortion.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "convergence/measurements.h"
#include "flow/bounded_flows.h"
#include "support/Record.h"
#include "support/handlebodies.h"

namespace cgp_benchmark {
namespace {

namespace CGP = Conformal_geometry_processing;
using CGP::Boundary_condition;
using CGP::Exactness;
using CGP::Mesh_view;

const int most_steps = 32, reference_steps = 256;  // from time 0 to 1

struct Time_case {
  std::string surface;
  Mesh_view mesh;
  Boundary_condition condition;
  std::string constraints;
  std::optional<Exactness> exactness;
};

CGP::Conformal_willmore_flow flow_of(const Time_case& c, int steps, double time_step)
{
  CGP::Flow_options options = cgp_test::plain_steps(time_step, steps, c.condition);
  options.surface.exactness = c.exactness;
  options.surface.max_period_defect = 1;  // the constraints alone
  options.surface.dirac.tolerance = 1e-10;
  return CGP::Conformal_willmore_flow(c.mesh, options);
}

Record record_of(const Time_case& c, const std::string& table, double time_step)
{
  Record record;
  record.add("table", table).add("surface", c.surface).add("constraints", c.constraints);
  record.add("faces", c.mesh.size_of_faces()).add("h", cgp_test::mean_edge_length(c.mesh));
  return record.add("tau", time_step);
}

void add(Record& record, const CGP::Conformality& map)
{
  record.add("q_mean", map.quasi_conformal.mean - 1).add("q_max", map.quasi_conformal.max - 1);
  record.add("ratio_rms", map.length_cross_ratio.rms).add("ratio_max", map.length_cross_ratio.max);
  record.add("flips", map.flipped_faces);
}

void measure_one_step(const Time_case& c)
{
  for (const double time_step : {.4, .2, .1, .05, .025, .0125}) {
    auto flow = flow_of(c, 1, time_step);
    const CGP::Flow_report report = flow.run();
    Record record = record_of(c, "step", time_step);
    add(record, report.conformality);
    record.add("gap", report.steps.at(0).period_defect);
    record.add("energy_before", report.initial_energy).add("energy", report.energy).print();
  }
}

/// from time 0 to 1 in more and more steps, against far more
void measure_unit_time(const Time_case& c)
{
  auto reference = flow_of(c, reference_steps, 1. / reference_steps);
  const CGP::Flow_report limit = reference.run();
  for (int steps = 1; steps <= most_steps; steps *= 2) {
    auto flow = flow_of(c, steps, 1. / steps);
    const CGP::Flow_report report = flow.run();
    Record record = record_of(c, "unit time", 1. / steps);
    add(record, report.conformality);
    double gap = 0;
    for (const auto& step : report.steps) gap += step.period_defect;
    record.add("steps", static_cast<int>(report.steps.size())).add("gap", gap);
    record.add("shape", CGP::align(flow.mesh().positions(), reference.mesh().positions()).rms);
    record.add("q_to_limit",
               CGP::quasi_conformal_error(reference.mesh(), flow.mesh().positions()).mean - 1);
    record.add("q_mean_limit", limit.conformality.quasi_conformal.mean - 1);
    record.add("ratio_rms_limit", limit.conformality.length_cross_ratio.rms);
    record.add("energy", report.energy).add("energy_limit", limit.energy).print();
  }
}

std::vector<Time_case> cases_of_genus_3(int level)
{
  const Mesh_view mesh = cgp_test::smooth_handlebody(3, level);
  return {{"genus 3", mesh, {}, "adjoint", Exactness::adjoint},
          {"genus 3", mesh, {}, "thesis", Exactness::thesis},
          {"genus 3", mesh, {}, "none", {}}};
}

std::vector<Time_case> cases_of_annulus(int n)
{
  const Mesh_view mesh = cgp_test::bumpy_annulus(n);
  std::vector<Time_case> list;
  const std::pair<const char*, Boundary_condition> conditions[] = {
      {"annulus, binormals", Boundary_condition::binormals()},
      {"annulus, tangents", Boundary_condition::tangents()},
      {"annulus, free", Boundary_condition::free()}};
  for (const auto& [name, condition] : conditions) {
    list.push_back({name, mesh, condition, "adjoint", Exactness::adjoint});
    list.push_back({name, mesh, condition, "none", {}});
  }
  return list;
}

}  // namespace

void measure_convergence_in_time()
{
  for (const int level : {2, 3})
    for (const Time_case& c : cases_of_genus_3(level)) measure_one_step(c);
  for (const Time_case& c : cases_of_annulus(16)) measure_one_step(c);
  for (const int level : {2, 3})
    for (const Time_case& c : cases_of_genus_3(level)) measure_unit_time(c);
  for (const Time_case& c : cases_of_annulus(16)) measure_unit_time(c);
}

}  // namespace cgp_benchmark
