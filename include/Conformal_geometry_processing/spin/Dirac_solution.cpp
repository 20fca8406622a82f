// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_solution.h>

#include <cmath>

namespace Conformal_geometry_processing {

internal::Dirac_evidence in_units(internal::Dirac_evidence evidence, double unit)
{
  for (double* number :
       {&evidence.eigenvalue, &evidence.dirac_residual, &evidence.gap, &evidence.branch_gap,
        &evidence.spectral_shift, &evidence.generalized_eigenvalue})
    *number /= unit;
  evidence.converged = evidence.converged && std::isfinite(evidence.eigenvalue);
  return evidence;
}

void internal::add_costs(Dirac_evidence& all, const Dirac_evidence& next)
{
  all.iterations += next.iterations;
  all.factorizations += next.factorizations;
  all.solves += next.solves;
  all.is_unfinished = all.is_unfinished || next.is_unfinished;
}

void internal::add_costs(Dirac_evidence::Seconds& all, const Dirac_evidence::Seconds& next)
{
  all.assembly += next.assembly;
  all.factorization += next.factorization;
  all.eigenvectors += next.eigenvectors;
}

}  // namespace Conformal_geometry_processing
