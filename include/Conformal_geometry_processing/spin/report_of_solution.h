// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_REPORT_OF_SOLUTION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_REPORT_OF_SOLUTION_H

#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <cmath>

namespace Conformal_geometry_processing {

/// \relates Spin_report
/// the part of the report that tells of the Dirac equation
/// \param unit the length in which the equation was solved
inline Spin_report report_of(const Dirac_solution& s, double unit)
{
  Spin_report r;
  r.converged = s.converged && std::isfinite(s.eigenvalue);
  r.cancelled = s.cancelled;
  r.eigenvalue = s.eigenvalue / unit;
  r.residual = s.residual;
  r.gap = s.gap / unit;
  r.overlap = s.overlap;
  r.iterations = s.iterations;
  r.substeps = s.substeps;
  r.spectral_shift = s.spectral_shift / unit;
  r.is_generalized = s.is_generalized;
  r.generalized_eigenvalue = s.generalized_eigenvalue / unit;
  r.seconds.assembly = s.seconds.assembly;
  r.seconds.factorization = s.seconds.factorization;
  r.seconds.eigenvectors = s.seconds.eigenvectors;
  return r;
}

}  // namespace Conformal_geometry_processing

#endif
