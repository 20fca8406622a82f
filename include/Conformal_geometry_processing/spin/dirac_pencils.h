// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/dense/block_operators.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Krylov_space.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/constant_spins.h>

#include <Eigen/Core>

#include <cmath>
#include <utility>

/// \file dirac_pencils.h
/// \brief the Hermitian pencils of D - rho on the space of spins of a `Dirac_system` with potential
/// rho. They refer to the system and to the excluded constants.

namespace Conformal_geometry_processing::internal {

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

}  // namespace Conformal_geometry_processing::internal
