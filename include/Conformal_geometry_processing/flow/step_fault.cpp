// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/step_fault.h>

#include <string>

namespace Conformal_geometry_processing {

std::string step_fault(const Spin_report& report, bool is_turning, bool is_exact,
                       const Flow_options& options)
{
  if (!report.converged) return "the Dirac equation is not solved";
  if (report.boundary_fault == Spin_report::Boundary_fault::not_realizable && is_turning)
    return to_string(report.boundary_fault);
  if (!options.backtracking) return {};
  const double distortion = report.conformality.quasi_conformal.mean;
  if (!(distortion < options.max_step_distortion.value_or(is_exact ? 1.15 : 1.5)))
    return "the mean quasi-conformal error is " + std::to_string(distortion);
  if (!(report.closure_residual < options.max_step_closure))
    return "the closure residual is " + std::to_string(report.closure_residual);
  return {};
}

}  // namespace Conformal_geometry_processing
