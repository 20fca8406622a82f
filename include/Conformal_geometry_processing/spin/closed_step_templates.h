// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CLOSED_STEP_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CLOSED_STEP_TEMPLATES_H

#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/closed_step.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

/// a single transformation, with its period defect
template <class Transformation>
Closed_step measured_step(Transformation& transformation, const Curvature_potential& rho,
                          const Dirac_options& options, const Go_further& go_further)
{
  const Exactness_constraints& exactness = transformation.exactness(rho.on);
  Closed_step step{transformation.step(rho, options, go_further), rho, {}};
  if (step.result.report.cancelled) return step;
  step.edges = transformed_edges(transformation.system().surface(), step.result.lambda);
  step.result.report.period_defect = exactness.period_defect(step.edges);
  return step;
}

template <class Transformation>
Closed_step closed_step(Transformation& transformation, const Curvature_potential& rho,
                        const Period_limit& limit, double share, const Dirac_options& options,
                        const Go_further& go_further)
{
  const Exactness_constraints& exactness = transformation.exactness(rho.on);
  const double unit = transformation.domain().unit();
  Closed_step best = measured_step(transformation, rho, options, go_further);
  const Spin_report& report = best.result.report;
  bool improves = exactness.functions.cols() > 0;
  while (improves && report.converged && !report.cancelled &&
         report.period_defect > limit(report, share)) {
    const Eigen::VectorXd change = exactness.closing_change(best.edges) / unit;
    Closed_step next =
        measured_step(transformation, {rho.on, best.rho.values + change}, options, go_further);
    const double before = report.period_defect, after = next.result.report.period_defect;
    improves = next.result.report.converged && after <= before / 4;
    if (next.result.report.cancelled || (next.result.report.converged && after < before))
      best = std::move(next);
  }
  return best;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
