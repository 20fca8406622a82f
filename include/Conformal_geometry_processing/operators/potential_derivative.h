// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <Eigen/Core>

#include <cstddef>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgOperators
/// the index of the value of rho at a corner
inline int potential_index(const Sheet& sheet, Curvature_potential::On on, std::size_t c)
{
  return on == Curvature_potential::On::vertices ? sheet.corners[c] : sheet.face;
}

/// \ingroup PkgOperators
/// \brief minus the derivative of X lambda for changes d of rho: (E^H M A + A^H M E) lambda with
/// A = D - R and E the matrix that multiplies by d and averages on faces; |V| x k. O(k sheets).
/// \param rho at which X is differentiated, in 1/length
/// \param changes |V| or |F| x k, where rho is
Block<Quaternion<double>> energy_change(const Surface_ref& surface, const Curvature_potential& rho,
                                        const Quaternion_vector<double>& lambda,
                                        const Eigen::MatrixXd& changes);

/// \ingroup PkgOperators
/// \brief the transpose of `energy_change()`: the gradients of -Re <z, X lambda> with respect to
/// rho for k columns z; |V| or |F| x k.
Eigen::MatrixXd energy_gradient(const Surface_ref& surface, const Curvature_potential& rho,
                                const Quaternion_vector<double>& lambda,
                                const Block<Quaternion<double>>& z);

/// \ingroup PkgOperators
/// \brief the gradient of -<lambda, H lambda> with respect to rho, H from `apply_dirac_form()`: the
/// integral of |B lambda|^2 for each value of rho; |V| or |F|.
Eigen::VectorXd form_gradient(const Surface_ref& surface, Curvature_potential::On on,
                              const Quaternion_vector<double>& lambda);

}  // namespace Conformal_geometry_processing::internal
