// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/exactness_functions.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

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

}  // namespace Conformal_geometry_processing::internal
