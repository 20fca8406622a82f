// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>

#include <Eigen/Core>

#include <functional>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// the discretisation of the exactness constraints
enum class Exactness {
  adjoint,  ///< the derivative of the discrete transformation: leaves an error of second order
  thesis    ///< solutions of D Z = v [CGP 6.4.5], least squares: leaves a first-order error O(h^2)
};

namespace internal {

/// \brief computes the response y of lambda = 1 to sources c: (D^H M D) y = c in the space of
/// spins; |V| x k -> |V| x k.
using Spin_response = std::function<Block<Quaternion<double>>(const Block<Quaternion<double>>&)>;

}  // namespace internal

/// \ingroup PkgForms
/// \brief the functions z to which rho must be orthogonal so that the edges of the spin transformed
/// surface stay exact to first order: 3k columns, three for each of the k harmonic forms [CGP
/// 4.5.2, 6.4.5].
///
/// For small rho the solution of (D - rho) lambda = gamma lambda is 1 + Y with D^H D Y = D^H rho,
/// and the harmonic part of the new edges, in the basis of forms and the axes of space, is to first
/// order twice the inner products of rho and z: sum_i A_i rho_i z_i with the areas
/// `curvature_areas()`. On isothermic surfaces, such as tori of revolution, only 6G - 1 of the 6G
/// functions are independent.
///
/// Costs one solve for each form if the space of spins is quaternionic, and one for each form and
/// axis if it is real (directions prescribed at a boundary).
///
/// \param on where the values of rho are
/// \param version `Exactness::thesis` on closed surfaces only
/// \returns |V| x 3k or |F| x 3k; column 3 i + a belongs to form i and axis a
Eigen::MatrixXd exactness_functions(
    const Surface_ref& surface, const Harmonic_basis& basis, const internal::Spin_response& respond,
    Curvature_potential::On on,
    internal::Coefficients coefficients = internal::Coefficients::quaternions,
    Exactness version = Exactness::adjoint);

}  // namespace Conformal_geometry_processing
