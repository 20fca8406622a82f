// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/boundary_fault.h>

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

double greatest_misfit(const Surface_ref& surface)
{
  const double pi = std::acos(-1.), radius = std::sqrt(face_areas(surface).sum() / pi);
  return (std::max)(0.05, 3 * mean_edge_length(surface) / radius) / radius;
}

double greatest_zero(const Surface_ref& surface)
{
  const double pi = std::acos(-1.), radius = std::sqrt(face_areas(surface).sum() / pi);
  const double h = mean_edge_length(surface) / radius;
  return (std::max)(0.05, h) / radius;
}

Spin_report::Boundary_fault boundary_fault(const Surface_ref& surface, double sigma,
                                           const Spin_report& report)
{
  const double pi = std::acos(-1.), radius = std::sqrt(face_areas(surface).sum() / pi);
  const double h = mean_edge_length(surface) / radius, small_gap = 0.01, great_misfit = 0.15;
  const double closing = report.closure_residual;
  if (sigma > greatest_misfit(surface) && (closing > small_gap || sigma * radius > great_misfit))
    return Spin_report::Boundary_fault::not_realizable;
  if (!report.has_positions && closing > (std::max)(report.limits.closure, 3 * h * h))
    return Spin_report::Boundary_fault::does_not_close;
  if (report.min_spin_ratio < 0.02) return Spin_report::Boundary_fault::degenerate;
  return Spin_report::Boundary_fault::none;
}

}  // namespace Conformal_geometry_processing
