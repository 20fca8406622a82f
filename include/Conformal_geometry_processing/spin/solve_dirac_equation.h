// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief solves (D - rho) lambda = gamma lambda [CGP (5.2), (5.3)] on the space of spins of a
/// system.
///
/// On a closed surface, lambda is the eigenvector on the branch that tends to 1 as rho tends to
/// zero. With prescribed directions, it is the singular vector of the smallest value, or one of the
/// next that is nearer to the guide of `Prescribed_directions` [CGP 5.7]. With prescribed
/// positions, it has the least energy among the spins with the given boundary values [CGP 6.3.2].
///
/// With a free boundary, lambda minimises |(D - rho) lambda|^2 + alpha^2 |lambda - 1|^2 with
/// alpha^2 = `nearness_weight()`. The eigenvector of the smallest eigenvalue, which [CGP 5.8.3]
/// takes, is arbitrary: without a boundary condition the kernel has infinite dimension, and the
/// discretisation error alone determines which of its vectors is smallest; that vector often has
/// zeros.
///
/// On closed surfaces, gamma is the quotient of lambda, and lambda the smallest eigenvector of the
/// energy X of rho + gamma; rho and rho + c have the same lambda. Costs one factorization for weak
/// rho, one more for each stage in which the branch is followed, and about ten solves for each.
///
/// \param rho finite values, in 1/length
/// \param go_further called between iterations with an `Eigensolver_progress`; cancels by returning
/// false
/// \throw Precondition_error if the generalized problem is requested with rho on vertices, or on a
/// surface with boundary
/// \throw Solver_error if a factorization fails. Failure to converge is not an error but a field of
/// the result.
internal::Dirac_solution solve_dirac_equation(
    internal::Dirac_system& system, const Curvature_potential& rho,
    const Dirac_options& options = {},
    const internal::Go_further& go_further = internal::Always_go_further());

}  // namespace Conformal_geometry_processing
