// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/surfaces/tori.h>

#include <cmath>
#include <complex>
#include <optional>
#include <string>

#include "convergence/measurements.h"
#include "flow/flow_tools.h"
#include "support/Record.h"
#include "support/skewed_tori.h"
#include "support/tori.h"

namespace cgp_benchmark {
namespace {

namespace CGP = Conformal_geometry_processing;
using CGP::Mesh_view;

Record record_of(const std::string& table, const std::string& surface, int n, const Mesh_view& mesh,
                 std::optional<double> limit)
{
  Record record;
  record.add("table", table).add("surface", surface).add("n", n);
  record.add("faces", mesh.size_of_faces()).add("h", CGP::mean_edge_length(mesh));
  return record.add("limit", limit.value_or(0));  // 0: the default
}

/// a wave in space that no symmetry of a torus leaves as it is
void measure_edit(const std::string& surface, int n, const Mesh_view& mesh,
                  std::optional<double> limit)
{
  Eigen::VectorXd rho(mesh.size_of_vertices());
  for (int v = 0; v < rho.size(); ++v) {
    const Eigen::Vector3d x = mesh.position(v);
    rho[v] = std::sin(3 * x[0] + 1) * std::cos(2 * x[1]) + .5 * std::sin(4 * x[2]);
  }
  CGP::Spin_transformation_options options;
  options.max_period_defect = limit;
  const CGP::Spin_report report = CGP::Spin_transformation(mesh, options)
                                      .transform(CGP::Curvature_potential::on_vertices(rho))
                                      .report;
  Record record = record_of("edit", surface, n, mesh, limit);
  record.add("q_mean", report.conformality.quasi_conformal.mean - 1);
  record.add("q_max", report.conformality.quasi_conformal.max - 1);
  record.add("steps", report.steps).add("gap", report.period_defect);
  record.add("closure", report.closure_residual).add("missing", report.missing_share).print();
}

/// how far the flow moves the conformal class of a torus from time 0 to 2
void measure_drift(int n, double time_step, std::optional<double> limit)
{
  const Mesh_view mesh = cgp_test::twisted_torus(n);
  const int steps = static_cast<int>(std::lround(2 / time_step));
  CGP::Flow_options options = cgp_test::plain_steps(time_step, steps);
  options.surface.max_period_defect = limit;
  CGP::Conformal_willmore_flow flow(mesh, options);
  double gap = 0, closure = 0;
  const CGP::Flow_report report = flow.run();
  for (const CGP::Flow_step_report& step : report.steps) {
    gap += step.period_defect;
    closure += step.spin.closure_residual;
  }
  const std::complex<double> before = CGP::conformal_modulus(mesh),
                             after = CGP::conformal_modulus(flow.mesh());
  Record record = record_of("drift", "twisted torus", n, mesh, limit);
  record.add("tau", time_step).add("before_re", before.real()).add("before_im", before.imag());
  record.add("after_re", after.real()).add("after_im", after.imag());
  record.add("gap", gap).add("closure", closure).add("energy", report.energy).print();
}

}  // namespace

void measure_handles()
{
  for (const std::optional<double> limit : {std::optional<double>(.02), std::optional<double>()})
    for (const int n : {24, 48, 96, 160}) {
      measure_edit("regular torus", n, cgp_test::torus(1, .4, 2 * n, n), limit);
      measure_edit("irregular torus", n, cgp_test::irregular_torus(1, .4, 2 * n, n), limit);
    }
  for (const int n : {8, 16, 24, 32, 48, 64})
    for (const double time_step : {.5, .25, .125})
      for (const double limit : {1., 1e-5}) measure_drift(n, time_step, limit);
}

}  // namespace cgp_benchmark
