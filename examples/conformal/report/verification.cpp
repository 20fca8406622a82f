// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "verification.h"

#include "conformal/process/text.h"

#include <Conformal_geometry_processing/mesh/well_shaped_faces.h>

#include <cmath>

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

std::string exceeds(const std::string& what, double value, double limit)
{
  int digits = 3;  // as many as show a difference
  while (digits < 17 && text_of(value, digits) == text_of(limit, digits)) ++digits;
  return what + " is " + text_of(value, digits) + ", more than " + text_of(limit, 3);
}

std::string fault_of(const Evidence& evidence, const Verification_limits& limits,
                     const std::string& easier)
{
  if (!evidence.fault.empty()) return evidence.fault;
  if (evidence.spin)
    return objection(*evidence.spin, evidence.positions, evidence.faces, limits, easier);
  if (!evidence.positions.allFinite()) return "coordinates are not finite; try: " + easier;
  return evidence.map ? objection(*evidence.map, evidence.faces, limits, easier) : "";
}

}  // namespace

Verdict judge(const Evidence& evidence, const Verification_limits& limits,
              const std::string& easier)
{
  Verdict verdict;
  verdict.fault = fault_of(evidence, limits, easier);
  verdict.map = evidence.spin ? evidence.spin->conformality : evidence.map;
  if (evidence.spin) verdict.closure_residual = evidence.spin->closure_residual;
  return verdict;
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

int measured_faces(const CGP::Spin_report& report, int faces)
{
  return report.mollification.share > 0 ? report.mollification.measured_faces : faces;
}

CGP::Mesh_view measured_part(const CGP::Mesh_view& mesh, bool is_mollified)
{
  return is_mollified ? CGP::well_shaped_faces(mesh).mesh : mesh;
}

}  // namespace conformal
