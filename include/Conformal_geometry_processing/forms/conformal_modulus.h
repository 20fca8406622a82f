// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_CONFORMAL_MODULUS_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_CONFORMAL_MODULUS_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <complex>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// the integral of a ^ b over the surface, for closed 1-forms: changes sign with the order and the
/// orientation, and does not change when exact forms are added
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
/// On the boundary of this domain, where there are two, rounding decides.
/// \pre Im tau > 0
inline std::complex<double> reduced_modulus(std::complex<double> tau)
{
  const double rounding = 1e-12;
  for (;;) {
    tau -= std::round(tau.real());
    if (std::norm(tau) >= 1 - rounding) return tau;
    tau = -1. / tau;  // Im tau grows, so this ends
  }
}

/// \ingroup PkgForms
/// \brief tau of a torus, which is conformally the plane modulo the lattice of 1 and tau.
///
/// From G_ij = <h_i, h_j> for the harmonic forms h_1, h_2 with integer periods and
/// integral h_1 ^ h_2 = 1: tau = (-G_12 + i sqrt(det G)) / G_22, reduced. Second order in the
/// fineness of the mesh. A reflection of the surface maps tau to -conjugate(tau).
///
/// No solve: the harmonic parts of the generators are their coefficients in the basis.
/// \pre `basis` is that of the mesh
/// \throw Precondition_error if the surface has a boundary, or its genus is not one
inline std::complex<double> conformal_modulus(const Mesh_view& mesh, const Harmonic_basis& basis)
{
  require_closed(mesh, "conformal_modulus");
  if (basis.genus() != 1)
    throw Precondition_error(
        "conformal_modulus",
        "the surface has genus " + std::to_string(basis.genus()) + "; a torus is needed");
  Eigen::MatrixXd generators = closed_generators(mesh);
  if (wedge_product(mesh, generators.col(0), generators.col(1)) < 0) generators.col(0) *= -1;
  const Eigen::Matrix2d periods = basis.coefficients(cotan_weights(mesh), generators);
  const Eigen::Matrix2d G = periods.transpose() * periods;
  return reduced_modulus({-G(0, 1) / G(1, 1), std::abs(periods.determinant()) / G(1, 1)});
}

}  // namespace Conformal_geometry_processing

#endif
