// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <cstddef>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief assembles X = (D - R)^H M (D - R), sheet by sheet [CGP Alg. 2].
///
/// X is |V| x |V|, quaternionic, Hermitian and positive semidefinite; dimensionless. For rho = 0
/// its real part is the cotan Laplacian, and its kernel on a closed surface consists of the
/// constants. A sheet with corners i, j, edges e_i, area A and curvatures rho_i contributes its
/// share of
///
///     X_ij += -e_i e_j / (4A) + (rho_i e_j - rho_j e_i) / 6 + A rho_i rho_j / 9,
///
/// which for rho on faces is the other formula of [CGP Alg. 2]. On a mesh, X grows like the inverse
/// of the height of the thinnest face; on a `Delaunay_view` the imaginary part is bounded by 1 per
/// entry and triangle, and the real part is the intrinsic Delaunay Laplacian. O(sheets), in place.
/// \param X a matrix on `vertex_graph(surface)`; its values are replaced
/// \pre no triangle has area zero
void assemble_dirac_energy(const Surface_ref& surface, const Curvature_potential& rho,
                           Hermitian_sparse_matrix<Quaternion<double>>& X);

/// \ingroup PkgOperators
/// X on a new pattern
Hermitian_sparse_matrix<Quaternion<double>> dirac_energy(const Surface_ref& surface,
                                                         const Curvature_potential& rho);

/// \ingroup PkgOperators
/// \brief the Hermitian part of B^H M (D - R), |V| x |V|, indefinite, in units of length; on a
/// closed surface with rho on faces the right-hand side of the generalized problem [CGP (5.2)].
///
/// A sheet contributes its share of (e_i - e_j) / 12 - A (rho_i + rho_j) / 18 to entry (i, j).
Hermitian_sparse_matrix<Quaternion<double>> dirac_form(const Surface_ref& surface,
                                                       const Curvature_potential& rho);

namespace internal {

/// \brief the two forms whose quotient is the *signed* eigenvalue of D - rho, on k vectors V: |V| x
/// k. Both are k x k and Hermitian.
struct Dirac_forms {
  Block<Quaternion<double>> dirac;  ///< the Hermitian part of V^H B^H M_F (D - R) V; indefinite
  Block<Quaternion<double>> mass;   ///< V^H B^H M_F B V; positive definite
};

/// row c of M (D - R) on a sheet, divided by its share; r: rho at the corners
inline Quaternion<double> dirac_row(const Sheet& sheet, const Eigen::Vector3d& r, int c)
{
  const auto e = sheet.vectors.col(c);
  return {-sheet.area * r[c] / 3, e[0] / -2, e[1] / -2, e[2] / -2};
}

/// the index of the value of rho at a corner
inline int potential_index(const Sheet& sheet, Curvature_potential::On on, std::size_t c)
{
  return on == Curvature_potential::On::vertices ? sheet.corners[c] : sheet.face;
}

/// \brief minus the derivative of X lambda for changes d of rho: (E^H M A + A^H M E) lambda with
/// A = D - R and E the matrix that multiplies by d and averages on faces; |V| x k. O(k sheets).
/// \param rho at which X is differentiated, in 1/length
/// \param changes |V| or |F| x k, where rho is
Block<Quaternion<double>> energy_change(const Surface_ref& surface, const Curvature_potential& rho,
                                        const Quaternion_vector<double>& lambda,
                                        const Eigen::MatrixXd& changes);

/// \brief the transpose of `energy_change()`: the gradients of -Re <z, X lambda> with respect to
/// rho for k columns z; |V| or |F| x k.
Eigen::MatrixXd energy_gradient(const Surface_ref& surface, const Curvature_potential& rho,
                                const Quaternion_vector<double>& lambda,
                                const Block<Quaternion<double>>& z);

/// \brief the gradient of -<lambda, H lambda> with respect to rho, H from `apply_dirac_form()`: the
/// integral of |B lambda|^2 for each value of rho; |V| or |F|.
Eigen::VectorXd form_gradient(const Surface_ref& surface, Curvature_potential::On on,
                              const Quaternion_vector<double>& lambda);

}  // namespace internal

/// \ingroup PkgOperators
/// the forms on the columns of `vectors`; O(sheets), without assembling a matrix
internal::Dirac_forms dirac_forms(const Surface_ref& surface, const Curvature_potential& rho,
                                  const Block<Quaternion<double>>& vectors);

/// \ingroup PkgOperators
/// \brief H lambda, |V|, where H is the Hermitian part of B^H M_F (D - R): the form `dirac` of
/// `Dirac_forms` as an operator. O(sheets), without assembling a matrix.
Quaternion_vector<double> apply_dirac_form(const Surface_ref& surface,
                                           const Curvature_potential& rho,
                                           const Quaternion_vector<double>& lambda);

/// \ingroup PkgOperators
/// \brief gamma = Re <B lambda, M_F (D - R) lambda> / <B lambda, M_F B lambda> for an eigenvector
/// lambda of X; in 1/length.
///
/// The eigenvalue mu of X is gamma^2 plus the discretisation error ([CGP (5.3)] writes gamma for
/// it): its root has no sign, and is inaccurate near zero.
double dirac_quotient(const Surface_ref& surface, const Curvature_potential& rho,
                      const Quaternion_vector<double>& lambda);

/// \ingroup PkgOperators
/// \brief Re <B lambda, M_F R lambda> / <B lambda, M_F B lambda>: a mean of rho, in 1/length, by
/// which `dirac_quotient()` is less than without rho. O(sheets).
double potential_quotient(const Surface_ref& surface, const Curvature_potential& rho,
                          const Quaternion_vector<double>& lambda);

/// \ingroup PkgOperators
/// \brief |(D - R) lambda| / |lambda|, in 1/length: the root of the Rayleigh quotient of X and the
/// vertex areas. Accurate to all digits even if it is zero up to rounding, because no terms cancel.
/// O(sheets), without assembling a matrix.
double dirac_misfit(const Surface_ref& surface, const Curvature_potential& rho,
                    const Quaternion_vector<double>& lambda,
                    const internal::Surface_part& part = {});

}  // namespace Conformal_geometry_processing
