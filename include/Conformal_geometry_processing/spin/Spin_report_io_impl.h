// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_REPORT_IO_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SPIN_REPORT_IO_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/spin/Spin_report_io.h>

#include <ostream>

namespace Conformal_geometry_processing {

CGP_INLINE std::ostream& operator<<(std::ostream& out, const Spin_report& r)
{
  const Conformality& c = r.conformality;
  out << "Dirac equation         " << (r.converged ? "solved" : "NOT solved") << ", residual "
      << r.residual << " after " << r.iterations << " iterations";
  if (r.substeps > 1) out << " in " << r.substeps << " substeps";
  out << ", " << r.factorizations << " factorizations";
  out << "\neigenvalue             " << r.eigenvalue << " (";
  if (r.gap > 0) out << "next one " << r.gap << " away, ";
  out << "overlap with the identity " << r.overlap << ")\n"
      << "closure                " << r.closure_residual << " of the edge lengths\n";
  if (r.steps != 1 || r.missing_share > 0)
    out << "handles kept closed    in " << r.steps << " steps, " << 100 * r.reached
        << " % of the way, " << 100 * r.missing_share << " % of rho left out\n";
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
  out << "quasi-conformal error  " << c.quasi_conformal.mean << " mean, " << c.quasi_conformal.p99
      << " for 99 %, " << c.quasi_conformal.max << " at most (1 is conformal)\n"
      << "length cross-ratios    changed by " << c.length_cross_ratio.rms << " rms, "
      << c.length_cross_ratio.max << " at most (0 is conformal)\n"
      << "lengths                scaled by " << c.scale.min_scale << " to " << c.scale.max_scale
      << "\nflipped faces          " << c.flipped_faces << "\nfault                  "
      << to_string(r.fault()) << '\n';
  return out;
}

}  // namespace Conformal_geometry_processing

#endif
