// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/algebra/Reduced_basis.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/krylov/Krylov_space.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

#include <Eigen/Core>

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

/// \ingroup PkgSpin
/// \brief the constant spins that turn the directions at the boundary into the prescribed ones: an
/// orthonormal basis over the reals of the quaternions q with q = B B^T q, at most four.
///
/// Kept directions admit 1 and, if they are all parallel, as the binormals of a cylinder are, the
/// rotations about them.
Vector<Quaternion<double>> constant_spins(const internal::Reduced_basis<double>& basis);

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
/// \pre rho is on faces: on vertices K is not Hermitian
void solve_generalized_dirac(internal::Dirac_system& system, const Curvature_potential& rho,
                             const Dirac_options& options, internal::Dirac_solution& s,
                             const internal::Go_further& go_further);

namespace internal {

// The Hermitian pencils of D - rho on the space of spins of a system with potential rho refer to
// the system and to the excluded constants.

/// the constants in the space of spins, M_V-orthonormal: the kernel of X for rho = 0
Block<Quaternion<double>> constants_in_space(const Dirac_system& system);

/// the part of a right-hand side b that vanishes on the constants
Block<Quaternion<double>> beside_constants(const Dirac_system& system,
                                           const Block<Quaternion<double>>& constants,
                                           Block<Quaternion<double>> b);

/// \brief X^-1 b without its constant component: that of b is rounding error, which the factor
/// would amplify.
Block<Quaternion<double>> solve_beside(const Dirac_system& system,
                                       const Block<Quaternion<double>>& constants,
                                       Block<Quaternion<double>> b);

/// K = M_V, N = X with the shift of its factor. K vanishes on the constants too: what rounding
/// brings in of them, which have the smallest N, would otherwise appear as the largest eigenvalue.
Pencil pencil_of_masses(const Dirac_system& system, const Block<Quaternion<double>>& constants);

/// K = the Hermitian part of B^H M (D - R), N as before
Pencil pencil_of_form(const Dirac_system& system, const Curvature_potential& rho,
                      const Block<Quaternion<double>>& constants);

/// `dirac_forms()` over the scalars of the space
Dirac_forms forms_in_space(const Dirac_system& system, const Curvature_potential& rho,
                           const Block<Quaternion<double>>& v);

}  // namespace internal

}  // namespace Conformal_geometry_processing
