// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_GRAM_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_GRAM_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgOperators
/// \brief the forms of D - t rho - sigma on the span of k vectors V, |V| x k, for every t and
/// sigma.
///
/// They are combinations of the inner products of the images D V, R V and B V on the faces, in the
/// norm of M_F: 3 k x 3 k numbers, with which following a branch in t costs nothing that depends on
/// the size of the mesh.
class Dirac_gram {
 public:
  /// O(k^2 sheets), without assembling a matrix
  Dirac_gram(const Surface_ref& surface, const Curvature_potential& rho,
             const Block<Quaternion<double>>& vectors);

  Eigen::Index size_of_vectors() const { return m_products.cols() / 3; }

  /// V^H X V for the energy X of t rho + sigma, k x k: Hermitian, positive semidefinite
  Block<Quaternion<double>> energy(double t, double sigma) const;

  /// \brief `dirac_quotient()` of D - t rho at V c, in 1/length.
  /// \param c k coefficients, not zero
  double quotient(double t, const Quaternion_vector<double>& c) const;

 private:
  enum Image : Eigen::Index { dirac, potential, average };

  /// c^H <image a, image b> c
  Quaternion<double> form(Image a, Image b, const Quaternion_vector<double>& c) const;

  Block<Quaternion<double>> m_products;  // [D V, R V, B V]^H M_F [D V, R V, B V]
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/operators/Dirac_gram_impl.h>
#endif

#endif
