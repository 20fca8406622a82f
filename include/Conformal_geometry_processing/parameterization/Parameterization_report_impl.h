// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PARAMETERIZATION_REPORT_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PARAMETERIZATION_REPORT_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/measure/Conformality_io.h>
#include <Conformal_geometry_processing/parameterization/Parameterization_report.h>

#include <ostream>

namespace Conformal_geometry_processing {

CGP_INLINE std::ostream& operator<<(std::ostream& out, const Parameterization_report& r)
{
  out << "eigenvector            " << (r.converged ? "found" : "NOT found") << ", residual "
      << r.residual << " after " << r.iterations << " iterations\n"
      << "eigenvalue             " << r.eigenvalue << " (next one " << r.next_eigenvalue << ")\n";
  internal::print_conformality(out, r.conformality);
  return out;
}

}  // namespace Conformal_geometry_processing

#endif
