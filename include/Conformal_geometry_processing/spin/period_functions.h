// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_PERIOD_FUNCTIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_PERIOD_FUNCTIONS_H

#include <Conformal_geometry_processing/forms/exactness_functions.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {
namespace internal {

/// \ingroup PkgSpin
/// \brief the derivative of the periods of a transformed surface by rho, at any transformation.
///
/// `exactness_functions()` are those at rho = 0 and lambda = 1. Where prescribed directions turn
/// the boundary, lambda is far from 1 even for rho = 0, and so is the derivative. A change of rho
/// changes the harmonic part of the new edges, to first order, by twice its inner products with
/// the columns, in the norm of the areas.
///
/// \param rho in 1/length, and \param lambda with (D - rho) lambda = 0 up to the discretisation
/// error
/// \param respond solves X y = c in the space of spins, orthogonal to lambda
/// \returns |V| x 3k or |F| x 3k; column 3 i + a belongs to form i and axis a
Eigen::MatrixXd period_functions(const Surface_ref& surface, const Harmonic_basis& basis,
                                 const Curvature_potential& rho,
                                 const Quaternion_vector<double>& lambda,
                                 const Spin_response& respond);

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/period_functions_impl.h>
#endif

#endif
