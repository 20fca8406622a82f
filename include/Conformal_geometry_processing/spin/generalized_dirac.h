// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \throw Precondition_error if rho is on vertices: K of the generalized problem is then not
/// Hermitian
void require_on_faces(const Curvature_potential& rho);

/// \ingroup PkgSpin
/// \brief replaces a solution of the standard problem by that of the generalized one, X lambda = g
/// K lambda with K = B^H M_F (D - R) [CGP (5.2)], if the latter is reliable.
///
/// [CGP] calls the generalized problem more robust, but it loses the wanted vector when gamma is
/// near zero: with the discretisation error delta^2 = mu - gamma^2 its eigenvalue is g = (gamma^2 +
/// delta^2) / gamma, and once that exceeds the next one in modulus, another eigenvector is the
/// smallest. The standard solution is therefore the initial guess and the criterion: the result is
/// accepted only if it is the smallest, has converged, and is on the same branch.
///
/// Solved as K lambda = (1/g) X lambda, whose right-hand side is positive definite.
/// Costs one factorization more than the standard problem.
/// \param system of a closed surface
/// \param s a converged solution of the standard problem; unchanged if the generalized one is
/// rejected
/// \pre `require_on_faces(rho)` holds
void solve_generalized_dirac(internal::Dirac_system& system, const Curvature_potential& rho,
                             const Dirac_options& options, internal::Dirac_solution& s,
                             const internal::Go_further& go_further);

}  // namespace Conformal_geometry_processing
