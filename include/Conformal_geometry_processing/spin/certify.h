// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CERTIFY_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CERTIFY_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/boundary_fault.h>

#include <Eigen/Core>

#include <limits>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Enters into the report how conformal the map from a surface to new positions is, and
/// between which lengths its spins are; one with a position that is not finite has not converged.
/// \param measured the surface, or the part of it that has areas
/// \param f 3 x |V| \param lambda |V|
void certify(const Mesh_view& measured, const Points& f, const Quaternion_vector<double>& lambda,
             Spin_report& report);

/// \brief Enters what came of the condition at the boundary.
/// \param surface before, `Mesh_view` or `Delaunay_view`, in the frame of the Dirac equation
/// \param moved returns the surface after, which is asked for only if its positions are finite
/// \param dirac a `Surface_dirac_equation` \param unit of the frame
template <class Surface, class Moved, class Equation>
void judge_boundary(const Surface& surface, const Moved& moved, bool is_finite,
                    const Equation& dirac, double unit, Spin_report& report)
{
  if (dirac.is_closed()) return;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (dirac.directions()) report.direction_error = {nan, nan};
  if (dirac.directions() && is_finite) {
    const Eigen::VectorXd errors = dirac.directions()->errors(moved());
    report.direction_error = {errors.mean(), errors.maxCoeff()};
  }
  const bool is_misfit = dirac.directions() && !dirac.is_self_adjoint();
  report.boundary_fault = boundary_fault(surface, is_misfit ? report.eigenvalue * unit : 0, report);
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/certify_impl.h>
#endif

#endif
