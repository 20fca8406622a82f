// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_BOUNDARY_FAULT_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_BOUNDARY_FAULT_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/mean_edge_length.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the greatest singular value of D - rho, in 1/length, that the length of the edges
/// explains: where gamma is a misfit, greater ones belong to no surface.
template <class Surface>
double greatest_misfit(const Surface& mesh)
{
  const double pi = std::acos(-1.), radius = std::sqrt(face_areas(mesh).sum() / pi);
  return (std::max)(0.05, 3 * mean_edge_length(mesh) / radius) / radius;
}

/// \ingroup PkgSpin
/// \brief whether what was prescribed at the boundary can be.
///
/// Of data that can, the singular value sigma of D - rho tends to zero with the length h of the
/// edges; of data that cannot, it stays. The residual of the positions tends to zero with the
/// square of h. Where it is small, there is a surface with this boundary nonetheless, and its
/// curvature is rho up to sigma: not less than prescribed binormals promise, which realise rho up
/// to gamma. Non-planar tangents are of this kind: exact solutions for them are exceptions [CGP
/// 5.7], good ones are not.
///
/// \param sigma in 1/length, or zero where it is a true eigenvalue and no misfit
/// \param report with what has been measured
template <class Surface>
Boundary_fault boundary_fault(const Surface& mesh, double sigma, const Spin_report& report)
{
  const double pi = std::acos(-1.), radius = std::sqrt(face_areas(mesh).sum() / pi);
  const double h = mean_edge_length(mesh) / radius, small_gap = 0.01, great_misfit = 0.15;
  const double closing = report.closure_residual;
  if (sigma > greatest_misfit(mesh) && (closing > small_gap || sigma * radius > great_misfit))
    return Boundary_fault::not_realizable;
  if (closing > (std::max)(0.02, 3 * h * h)) return Boundary_fault::does_not_close;
  if (report.min_spin_ratio < 0.02) return Boundary_fault::degenerate;
  return Boundary_fault::none;
}

}  // namespace Conformal_geometry_processing

#endif
