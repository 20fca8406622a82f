// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verification.h"

#include <Conformal_geometry_processing/mesh/well_shaped_faces.h>

#include <cmath>
#include <vector>

namespace conformal {
namespace {

/// Describes boundary faults that are not covered by the limits.
std::string fault_of_boundary(const CGP::Spin_report& report, const Verification_limits& limits,
                              const std::string& easier)
{
  const std::string what = CGP::to_string(report.boundary_fault);
  if (report.boundary_fault == CGP::Spin_report::Boundary_fault::not_realizable)
    return what + "; try: binormals instead of tangents, the tangents of a plane curve, or " +
           easier;
  if (report.boundary_fault == CGP::Spin_report::Boundary_fault::degenerate)
    return what + "; try: " + easier + ", or a finer mesh";
  const double missed = report.direction_error.mean * 180 / std::acos(-1.);
  if (!(missed <= limits.direction_error))
    return "directions at the boundary are missed by " + text_of(missed, 3) +
           " degrees in the mean, more than " + text_of(limits.direction_error, 3) +
           "; try: " + easier + ", a finer mesh, or --max-direction-error";
  return {};
}

/// Returns the number of faces included in the conformality
int measured_faces(const CGP::Spin_report& report, int faces)
{
  return report.mollification.share > 0 ? report.mollification.measured_faces : faces;
}

std::string exceeds(const std::string& what, double value, double limit)
{
  int digits = 3;  // as many as show a difference
  while (digits < 17 && text_of(value, digits) == text_of(limit, digits)) ++digits;
  return what + " is " + text_of(value, digits) + ", more than " + text_of(limit, 3);
}

}  // namespace

CGP::Mesh_view measured_part(const CGP::Mesh_view& mesh, bool is_mollified)
{
  return is_mollified ? CGP::well_shaped_faces(mesh).mesh : mesh;
}

void report_mollification(const CGP::Spin_report::Mollification& made, Report& report)
{
  if (made.share == 0) return;
  report.set("result/mollification/share", made.share);
  report.set("result/mollification/thin_faces", made.thin_faces);
  report.set("result/mollification/longer_edges", made.longer_edges);
  report.set("result/mollification/added_length", made.added_length);
  report.set("result/mollification/flipped_edges", made.flipped_edges);
  report.set("result/mollification/measured_faces", made.measured_faces);
  report.set("result/mollification/measured_area", made.measured_area);
}

void add_mollification(const CGP::Spin_report::Mollification& made, Table& table)
{
  if (made.share == 0) return;
  table.add("thin faces", std::to_string(made.thin_faces));
  table.add("edges made longer",
            std::to_string(made.longer_edges) +
                (made.longer_edges > 0 ? ", each by " + text_of(made.added_length, 3) : ""));
  table.add("edges flipped", std::to_string(made.flipped_edges));
  table.add("measured", text_of(100 * made.measured_area, 4) + " % of the area, " +
                            count_of(static_cast<std::size_t>(made.measured_faces), "face"));
}

std::string objection(const CGP::Spin_report& report, const CGP::Points& positions, int faces,
                      const Verification_limits& limits, const std::string& easier)
{
  if (report.steps == 0)
    return "no part of rho could be reached with handles and holes closed; try: a weaker rho, a "
           "finer mesh, or --open-handles";
  // Written such that NaN violates the limit.
  if (!std::isfinite(report.eigenvalue))
    return "the eigenvalue is not finite: the mesh is too small or too thin; try: a finer mesh";
  if (!report.converged)
    return "the eigenvector did not converge: residual " + text_of(report.residual, 3) + " after " +
           count_of(static_cast<std::size_t>(report.iterations), "iteration") + "; try: " + easier +
           ", or a larger --tolerance";
  if (!positions.allFinite()) return "coordinates are not finite; try: " + easier;
  const std::string fault = fault_of_boundary(report, limits, easier);
  if (!fault.empty()) return fault;
  if (!(report.closure_residual <= limits.closure))
    return exceeds("the closure residual", report.closure_residual, limits.closure) +
           ": the surface does not close up; try: " + easier + ", or --max-closure";
  return objection(report.conformality, measured_faces(report, faces), limits, easier);
}

std::string objection(const CGP::Conformality& map, int faces, const Verification_limits& limits,
                      const std::string& easier)
{
  if (!(map.quasi_conformal.mean <= limits.quasi_conformal))
    return exceeds("the mean quasi-conformal error", map.quasi_conformal.mean,
                   limits.quasi_conformal) +
           "; try: " + easier + ", a finer mesh, or --max-quasi-conformal";
  const double share = static_cast<double>(map.flipped_faces) / faces;
  if (!(share <= limits.flipped))
    return exceeds("the share of flipped faces", share, limits.flipped) + "; try: " + easier +
           ", a finer mesh, or --max-flipped";
  return {};
}

void report_conformality(const CGP::Conformality& map, Report& report)
{
  report.set("result/quasi_conformal/mean", map.quasi_conformal.mean);
  report.set("result/quasi_conformal/p99", map.quasi_conformal.p99);
  report.set("result/quasi_conformal/max", map.quasi_conformal.max);
  report.set("result/length_cross_ratio/rms", map.length_cross_ratio.rms);
  report.set("result/length_cross_ratio/max", map.length_cross_ratio.max);
  report.set("result/scale/min", map.scale.min_scale);
  report.set("result/scale/max", map.scale.max_scale);
  report.set("result/flipped_faces", map.flipped_faces);
}

void report_certificate(const CGP::Spin_report& spin, Report& report)
{
  report.set("result/eigenvalue", spin.eigenvalue);
  report.set("result/residual", spin.residual);
  report.set("result/gap", spin.gap);
  report.set("result/iterations", spin.iterations);
  report.set("result/closure_residual", spin.closure_residual);
  report_conformality(spin.conformality, report);
  report.set("result/min_spin_ratio", spin.min_spin_ratio);
  report.set("result/overlap", spin.overlap);
  report.set("result/substeps", spin.substeps);
  report.set("result/spectral_shift", spin.spectral_shift);
  report.set("result/generalized", spin.is_generalized);
  report.set("result/steps", spin.steps);
  report.set("result/reached", spin.reached);
  report.set("result/missing_share", spin.missing_share);
  report.set("result/period_defect", spin.period_defect);
  report_mollification(spin.mollification, report);
  report.set("steps", Report::Value(std::vector<double>()));
  report.add_seconds("assembly", spin.seconds.assembly);
  report.add_seconds("factorization", spin.seconds.factorization);
  report.add_seconds("solve", spin.seconds.eigenvectors);
  report.add_seconds("reconstruction", spin.seconds.reconstruction);
  report.add_seconds("setup", spin.seconds.setup);
  report.add_seconds("certificate", spin.seconds.certificate);
}

void add_conformality(const CGP::Conformality& map, int faces, Table& table)
{
  table.add("quasi-conformal error, mean", map.quasi_conformal.mean);
  table.add("quasi-conformal error, 99 %", map.quasi_conformal.p99);
  table.add("quasi-conformal error, max", map.quasi_conformal.max);
  table.add("log length cross-ratio change, rms", map.length_cross_ratio.rms);
  table.add("log length cross-ratio change, max", map.length_cross_ratio.max);
  table.add("scale of lengths",
            text_of(map.scale.min_scale) + " to " + text_of(map.scale.max_scale));
  table.add("flipped faces", std::to_string(map.flipped_faces) + " of " + std::to_string(faces));
}

Table certificate_table(const CGP::Spin_report& spin, int faces)
{
  Table table;
  table.add("eigenvalue gamma (1/length)", spin.eigenvalue);
  table.add("residual of the eigenvector", text_of(spin.residual, 3));
  table.add("gap to the next eigenvalue", spin.gap);
  table.add("iterations",
            std::to_string(spin.iterations) +
                (spin.substeps > 1 ? " in " + std::to_string(spin.substeps) + " substeps" : ""));
  table.add("closure residual", text_of(spin.closure_residual, 3));
  table.add("min / max of |lambda|", text_of(spin.min_spin_ratio, 3));
  if (spin.steps != 1 || spin.missing_share > 0) {
    table.add("steps that keep handles closed", spin.steps);
    table.add("left out of rho, for handles (%)", text_of(100 * spin.missing_share, 3));
  }
  add_mollification(spin.mollification, table);
  add_conformality(spin.conformality, measured_faces(spin, faces), table);
  return table;
}

}  // namespace conformal
