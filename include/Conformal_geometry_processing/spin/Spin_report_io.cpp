// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_report_io.h>

#include <Conformal_geometry_processing/measure/Conformality.h>

#include <ostream>
#include <string>

namespace Conformal_geometry_processing {

namespace internal {

/// the fault in words, and which of the faults of its kind it is
std::string reason_of(const Spin_report& r)
{
  const Spin_report::Fault fault = r.fault();
  const std::string reason = to_string(fault);
  if (fault == Spin_report::Fault::boundary) return reason + ": " + to_string(r.boundary_fault);
  if (fault == Spin_report::Fault::map)
    return reason + ": " + to_string(r.conformality.fault(r.limits.map));
  return reason;
}

}  // namespace internal

std::ostream& operator<<(std::ostream& out, const Spin_report& r)
{
  const char* const failed = r.cancelled ? "cancelled" : "NOT solved";
  const char* const solved = r.is_relaxed ? "relaxed" : "solved";
  out << "Dirac equation         " << (r.converged ? solved : failed) << ", residual "
      << (r.is_relaxed ? r.dirac_residual : r.residual) << " after " << r.iterations
      << " iterations";
  if (r.substeps > 1) out << " in " << r.substeps << " substeps";
  out << ", " << r.factorizations << " factorizations";
  out << (r.is_relaxed ? "\ngamma                  " : "\neigenvalue             ") << r.eigenvalue
      << " (";
  if (r.gap > 0) out << "next one " << r.gap << " away, ";
  out << "overlap with the identity " << r.overlap << ")\n"
      << "closure                " << r.closure_residual << " of the edge lengths\n";
  if (r.steps != 1 || r.missing_share > 0)
    out << "handles kept closed    " << 100 * r.reached << " % of the way, "
        << 100 * r.realised_share << " % of rho realised and " << 100 * r.missing_share
        << " % left out, by norm\n";
  if (r.added_share > 0)
    out << "added to close holes   a rho of " << 100 * r.added_share
        << " % of the curvature of a sphere\n";
  if (r.scales.bound > 0)
    out << "scale control          98 % of the area scaled by " << r.scales.low << " to "
        << r.scales.high << " with a bound of " << r.scales.bound << ", "
        << 100 * r.scales.kept_norm << " % of rho kept, correlation " << r.scales.kept_correlation
        << '\n';
  if (r.exact_class)
    out << "exact conformal class  " << (r.exact_class->converged ? "reached" : "NOT reached")
        << ", length cross-ratios kept to " << r.exact_class->length_cross_ratio.max
        << ", before to " << r.exact_class->initial_length_cross_ratio.max << ", "
        << r.exact_class->factorizations << " factorizations\n";
  if (r.mollification.share > 0)
    out << "mollification          " << r.mollification.thin_faces << " thin faces, "
        << r.mollification.longer_edges << " edges longer by " << r.mollification.added_length
        << ", " << r.mollification.flipped_edges << " flips, "
        << 100 * r.mollification.measured_area << " % of the area measured\n";
  if (r.direction_error.max > 0)
    out << "directions             missed by " << r.direction_error.mean << " radians in the mean, "
        << r.direction_error.max << " at most\n";
  if (r.position_error.max > 0)
    out << "positions              missed by " << r.position_error.mean << " in the mean, "
        << r.position_error.max << " at most\n";
  if (r.collar)
    out << "collar                 quasi-conformal error " << r.collar->quasi_conformal.mean
        << " in the mean, " << r.collar->quasi_conformal.max << " at most\n";
  if (const auto& realised = r.realised_curvature)
    out << "change of curvature    " << 100 * realised->share << " % of rho, correlation "
        << realised->correlation << ", wrong sign on " << 100 * realised->wrong_sign
        << " % of the area, distance " << realised->distance << '\n';
  internal::print_conformality(out, r.conformality);
  return out << "fault                  " << internal::reason_of(r) << '\n';
}

}  // namespace Conformal_geometry_processing
