// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_BOUNDARY_FAULT_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_BOUNDARY_FAULT_H

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the greatest singular value of D - rho, in 1/length, that the length of the edges
/// explains: where gamma is a misfit, greater ones belong to no surface.
double greatest_misfit(const Surface_ref& surface);

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
Boundary_fault boundary_fault(const Surface_ref& surface, double sigma, const Spin_report& report);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/boundary_fault_impl.h>
#endif

#endif
