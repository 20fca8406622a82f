// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "verification.h"

#include "conformal/process/text.h"

#include <Conformal_geometry_processing/mesh/requirements.h>

#include <cmath>

namespace conformal {
namespace {

double in_degrees(double radians)
{
  return radians * 180 / std::acos(-1.);
}

/// Describes boundary faults that are not covered by the limits.
std::string fault_of_boundary(const CGP::Spin_report& report,
                              const CGP::Spin_report::Limits& limits, const std::string& easier)
{
  const std::string what = CGP::to_string(report.boundary_fault);
  const bool is_part = report.reached > 0 && report.reached < 1;
  const std::string part =
      is_part ? "; " + text_of(100 * report.reached, 2) + " % of the way there is one" : "";
  if (report.boundary_fault != CGP::Spin_report::Boundary_fault::none)
    return what + part + "; try: " + easier + ", or a finer mesh";
  return "directions at the boundary are missed by " +
         text_of(in_degrees(report.direction_error.mean), 3) + " degrees in the mean, more than " +
         text_of(in_degrees(limits.direction_error), 3) + "; try: " + easier +
         ", a finer mesh, or --limit direction_error";
}

std::string exceeds(const std::string& what, double value, double limit)
{
  int digits = 3;  // as many as show a difference
  while (digits < 17 && text_of(value, digits) == text_of(limit, digits)) ++digits;
  return what + " is " + text_of(value, digits) + ", more than " + text_of(limit, 3);
}

std::string fault_of(const Evidence& evidence, const CGP::Spin_report::Limits& limits,
                     const std::string& easier)
{
  if (!evidence.fault.empty()) return evidence.fault;
  if (evidence.spin) return objection(*evidence.spin, evidence.positions, limits, easier);
  if (!evidence.positions.allFinite()) return "coordinates are not finite; try: " + easier;
  return evidence.map ? objection(*evidence.map, limits, easier) : "";
}

}  // namespace

Verdict judge(const Evidence& evidence, const CGP::Spin_report::Limits& limits,
              const std::string& easier)
{
  Verdict verdict;
  verdict.fault = fault_of(evidence, limits, easier);
  verdict.map = evidence.spin ? evidence.spin->conformality : evidence.map;
  if (evidence.spin) verdict.closure_residual = evidence.spin->closure_residual;
  return verdict;
}

std::string objection(const CGP::Spin_report& report, const CGP::Points& positions,
                      const CGP::Spin_report::Limits& limits, const std::string& easier)
{
  using Fault = CGP::Spin_report::Fault;
  CGP::Spin_report judged = report;
  judged.limits = limits;
  switch (judged.fault()) {
    case Fault::nothing_left:
      if (report.boundary_fault != CGP::Spin_report::Boundary_fault::none)
        return fault_of_boundary(report, limits, easier);
      return "no part of rho could be reached with handles and holes closed; try: a weaker rho, a "
             "finer mesh, or --open-handles";
    case Fault::not_finite:
      return "the eigenvalue is not finite: the mesh is too small or too thin; try: a finer mesh";
    case Fault::cancelled:
    case Fault::not_solved:
      return (report.is_relaxed
                  ? "no spins were found"
                  : "the eigenvector did not converge: residual " + text_of(report.residual, 3)) +
             " after " + count_of(static_cast<std::size_t>(report.iterations), "iteration") +
             "; try: " + easier + ", or a finer mesh";
    case Fault::boundary:
    case Fault::directions:
      return fault_of_boundary(report, limits, easier);
    case Fault::curvature:
      return exceeds("gamma times the radius", std::abs(report.gamma_radius()),
                     limits.gamma_radius) +
             ": the new surface has another mean curvature than rho says; try: " + easier +
             ", or --limit gamma_radius";
    case Fault::left_out:
      if (report.scales.kept_norm < limits.kept_norm)
        return "only " + text_of(100 * report.scales.kept_norm, 3) +
               " % of the norm of rho keeps lengths within a factor of " +
               text_of(report.scales.bound, 3) +
               "; try: a larger --max-scale, rho with smaller features, or --limit kept_norm";
      return "only " + text_of(100 * report.realised_share, 3) +
             " % of the norm of rho is realised: the rest would open handles or holes; try: a "
             "weaker rho, a "
             "finer mesh, --limit realised_share, or --open-handles";
    case Fault::open:
      if (report.closure_residual <= limits.closure)
        return exceeds("the period defect", report.period_defect, report.period_limit) +
               ": handles or holes do not close up; try: " + easier + ", or a finer mesh";
      return exceeds("the closure residual", report.closure_residual, limits.closure) +
             ": the surface does not close up; try: " + easier + ", or --limit closure";
    case Fault::scales:
      return "lengths change by factors of " + text_of(report.scales.low, 3) + " to " +
             text_of(report.scales.high, 3) + ", at tips of " + text_of(report.scales.tip_low, 3) +
             " to " + text_of(report.scales.tip_high, 3) + ", beyond the bound of " +
             text_of(report.scales.bound, 3) + "; try: " + easier + ", or a larger --max-scale";
    case Fault::exact_class:
      return "the exact conformal class is not reached; try: " + easier +
             ", or without --exact-class";
    case Fault::unrealised:
      return shortfall(report);
    case Fault::map:
    case Fault::none:
      break;
  }
  if (!positions.allFinite()) return "coordinates are not finite; try: " + easier;
  return objection(report.conformality, limits, easier);
}

std::string shortfall(const CGP::Spin_report& report)
{
  if (!report.falls_short()) return {};
  const CGP::Realised_curvature& realised = *report.realised_curvature;
  const bool is_bound = report.scales.weight > 0;
  const bool has_handles = report.missing_share > 0.5;
  return "the curvature has changed by " + text_of(100 * realised.share, 3) +
         " % of rho with a correlation of " + text_of(realised.correlation, 3) +
         ", measured on the new surface; try: " +
         (is_bound            ? "a larger --max-scale, rho with larger features, or a finer mesh"
          : has_handles       ? "rho with smaller features, or --open-handles"
          : report.is_relaxed ? "a weaker rho, or a finer mesh"
                              : "--max-scale 2, a weaker rho, or a finer mesh");
}

std::string objection(const CGP::Conformality& map, const CGP::Spin_report::Limits& limits,
                      const std::string& easier)
{
  using Fault = CGP::Conformality::Fault;
  switch (map.fault(limits.map)) {
    case Fault::not_conformal: {
      const double mean = map.quasi_conformal.mean, now = map.quasi_conformal_of_new_area;
      const bool is_old = !(mean <= limits.map.quasi_conformal);
      return exceeds(is_old ? "the mean quasi-conformal error"
                            : "the mean quasi-conformal error over the new area",
                     is_old ? mean : now, limits.map.quasi_conformal) +
             "; try: " + easier + ", a finer mesh, or --limit quasi_conformal";
    }
    case Fault::flipped:
      return exceeds("the share of flipped faces", map.flipped_share, limits.map.flipped_share) +
             "; try: " + easier + ", a finer mesh, or --limit flipped_share";
    case Fault::collapsed:
      return exceeds("the share of the area that has collapsed", map.scale.collapsed_share,
                     limits.map.collapsed_share) +
             "; try: " + easier + ", or --limit collapsed_share";
    case Fault::none:
      break;
  }
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
