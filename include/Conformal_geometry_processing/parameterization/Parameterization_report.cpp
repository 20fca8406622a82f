// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/Parameterization_report.h>

#include <Conformal_geometry_processing/measure/Conformality_io.h>

#include <ostream>

namespace Conformal_geometry_processing {

std::ostream& operator<<(std::ostream& out, const Parameterization_report& r)
{
  out << "eigenvector            " << (r.converged ? "found" : "NOT found") << ", residual "
      << r.residual << " after " << r.iterations << " iterations\n"
      << "eigenvalue             " << r.eigenvalue << " (next one " << r.next_eigenvalue << ")\n";
  internal::print_conformality(out, r.conformality);
  return out;
}

}  // namespace Conformal_geometry_processing
