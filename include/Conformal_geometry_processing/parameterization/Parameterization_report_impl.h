// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PARAMETERIZATION_REPORT_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PARAMETERIZATION_REPORT_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/parameterization/Parameterization_report.h>

#include <ostream>

namespace Conformal_geometry_processing {

CGP_INLINE std::ostream& operator<<(std::ostream& out, const Parameterization_report& r)
{
  const Conformality& c = r.conformality;
  return out << "eigenvector            " << (r.converged ? "found" : "NOT found") << ", residual "
             << r.residual << " after " << r.iterations << " iterations\n"
             << "eigenvalue             " << r.eigenvalue << " (next one " << r.next_eigenvalue
             << ")\nquasi-conformal error  " << c.quasi_conformal.mean << " mean, "
             << c.quasi_conformal.p99 << " for 99 %, " << c.quasi_conformal.max
             << " at most (1 is conformal)\n"
             << "length cross-ratios    changed by " << c.length_cross_ratio.rms << " rms, "
             << c.length_cross_ratio.max << " at most (0 is conformal)\n"
             << "lengths                scaled by " << c.scale.min_scale << " to "
             << c.scale.max_scale << "\nflipped faces          " << c.flipped_faces << '\n';
}

}  // namespace Conformal_geometry_processing

#endif
