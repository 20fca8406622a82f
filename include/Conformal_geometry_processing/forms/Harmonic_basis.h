// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/direct/Grounded_solver.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// \brief the harmonic 1-forms of a surface: 2G for genus G, or 2G + loops - 1 with a boundary;
/// orthonormal with respect to sum_e w_e omega_e omega'_e.
///
/// They are closed, d1 omega = 0, and co-closed, d0^T w omega = 0; at a boundary, their fields are
/// therefore tangent to it. The choice of the basis depends on the numbering of the mesh.
struct Harmonic_basis {
  Eigen::MatrixXd one_forms;   ///< |E| x `size()`, along each edge i -> j, i < j; dimensionless
  std::vector<Points> fields;  ///< each 3 x sheets: `tangent_field()` of the forms, in 1/length

  int size() const { return static_cast<int>(one_forms.cols()); }
  int genus() const { return size() / 2; }  ///< of closed surfaces

  /// \brief <omega_i, alpha> for the forms omega_i of the basis and the columns alpha: `size()` x
  /// k.
  ///
  /// The harmonic part of alpha is `one_forms * coefficients(w, alpha)`; its squared norm is the
  /// sum of the squared coefficients.
  /// \param w `cotan_weights(surface)` \param alpha |E| x k
  Eigen::MatrixXd coefficients(const Eigen::VectorXd& w, const Eigen::MatrixXd& alpha) const;
};

namespace internal {

/// \brief Subtracts d0 u with L u = d0^T w omega from 1-forms omega; the result is co-closed.
/// \param laplacian solves with L of the surface
void remove_exact_parts(const Surface_ref& surface, const Eigen::VectorXd& w,
                        const Grounded_solver& laplacian, Eigen::MatrixXd& forms);

/// Replaces closed forms by orthonormal ones with the same span. Uses their fields, whose inner
/// products are positive definite despite rounding, unlike sums with negative cotan weights.
/// \throw Precondition_error if they are linearly dependent, or a number is not finite
void orthonormalize_forms(const Surface_ref& surface, Eigen::MatrixXd& forms);

}  // namespace internal
}  // namespace Conformal_geometry_processing
