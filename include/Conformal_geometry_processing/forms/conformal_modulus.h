// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <complex>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// the integral of a ^ b over the surface, for closed 1-forms: changes its sign with the order and
/// the orientation, and is invariant under the addition of exact forms
/// \param a, b |E| numbers, along each edge i -> j, i < j
template <class A, class B>
double wedge_product(const Mesh_view& mesh, const Eigen::MatrixBase<A>& a,
                     const Eigen::MatrixBase<B>& b)
{
  double sum = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const int g = 3 * f, h = 3 * f + 1;
    sum += along_halfedge(mesh, a, g) * along_halfedge(mesh, b, h) -
           along_halfedge(mesh, a, h) * along_halfedge(mesh, b, g);
  }
  return sum / 2;
}

/// \ingroup PkgForms
/// \brief the representative of a modulus under SL(2, Z): |Re tau| <= 1/2 and |tau| >= 1.
///
/// On the boundary of this domain, where there are two representatives, rounding decides.
/// \pre Im tau > 0
std::complex<double> reduced_modulus(std::complex<double> tau);

/// \ingroup PkgForms
/// \brief tau of a torus, which is conformally equivalent to the plane modulo the lattice of 1 and
/// tau.
///
/// From G_ij = <h_i, h_j> for the harmonic forms h_1, h_2 with integer periods and integral h_1 ^
/// h_2 = 1: tau = (-G_12 + i sqrt(det G)) / G_22, reduced. Second order in the edge length. A
/// reflection of the surface maps tau to -conjugate(tau).
///
/// Needs no solve: the coefficients of the generators in the basis give their harmonic parts.
/// \pre `basis` belongs to the mesh
/// \throw Precondition_error if the surface has a boundary, or its genus is not one
std::complex<double> conformal_modulus(const Mesh_view& mesh, const Harmonic_basis& basis);

namespace internal {

/// \brief The inner products <h_i, h_j> of the harmonic forms of the cohomology classes of
/// `closed_generators()`, 2G x 2G: conformally invariant, and by Torelli's theorem they determine
/// the conformal type. Surfaces of the same connectivity have the same classes.
///
/// One factorization of the Laplacian and 2G solves.
/// \param mesh closed
/// \throw Solver_error if the factorization fails
Eigen::MatrixXd harmonic_energies(const Mesh_view& mesh);

/// \brief The distance of two such matrices: (max log t - min log t) / 2 over the eigenvalues t of
/// A^-1 B, which are t and 1 / t but for the error of the discrete energies, a common factor.
///
/// For tori it is the hyperbolic distance of their moduli: for rectangles of proportions b and c,
/// |log(b / c)|. Infinite if a matrix is not positive definite.
double conformal_type_distance(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace internal
}  // namespace Conformal_geometry_processing
