// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_HARMONIC_BASIS_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_HARMONIC_BASIS_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/forms/tangent_field.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/divergence.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// \brief the harmonic 1-forms of a surface, 2G of them for genus G, and 2G + loops - 1 where it
/// has a boundary; orthonormal with respect to sum_e w_e omega_e omega'_e.
///
/// They are closed, d1 omega = 0, and co-closed, d0^T w omega = 0, which at a boundary makes their
/// fields tangent to it. Which basis of their space it is, depends on the numbering of the mesh.
struct Harmonic_basis {
  Eigen::MatrixXd one_forms;   ///< |E| x `size()`, along each edge i -> j, i < j; dimensionless
  std::vector<Points> fields;  ///< each 3 x |F|: `tangent_field()` of the forms, in 1/length

  int size() const { return static_cast<int>(one_forms.cols()); }
  int genus() const { return size() / 2; }  ///< of closed surfaces

  /// \brief <omega_i, alpha> for the forms of the basis and those given: `size()` x k.
  ///
  /// The harmonic part of alpha is `one_forms * coefficients(w, alpha)`, and what the coefficients
  /// square and sum up to is its squared norm.
  /// \param w `cotan_weights(mesh)` \param alpha |E| x k
  Eigen::MatrixXd coefficients(const Eigen::VectorXd& w, const Eigen::MatrixXd& alpha) const
  {
    Eigen::MatrixXd products(size(), alpha.cols());
    for (Eigen::Index k = 0; k < alpha.cols(); ++k) {
      const Eigen::VectorXd weighted = w.cwiseProduct(alpha.col(k));
      for (Eigen::Index i = 0; i < products.rows(); ++i)
        products(i, k) = one_forms.col(i).dot(weighted);
    }
    return products;
  }
};

namespace internal {

/// \brief Takes d0 u with L u = d0^T w omega off 1-forms omega: what is left is co-closed.
/// \tparam Surface `Mesh_view` or `Delaunay_view`
/// \param laplacian solves with L of the surface
template <class Surface, class Laplacian>
void remove_exact_parts(const Surface& mesh, const Eigen::VectorXd& w, const Laplacian& laplacian,
                        Eigen::MatrixXd& forms)
{
  constexpr Eigen::Index at_once = 16;  // columns: what bounds the memory for solutions
  for (Eigen::Index first = 0; first < forms.cols(); first += at_once) {
    auto some = forms.middleCols(first, (std::min)(at_once, forms.cols() - first));
    some -= differential(mesh, laplacian.solve(codifferential(mesh, w, some)));
  }
}

/// The fields of closed forms, each vector times the root of its face's area, one form per column:
/// ordinary inner products of the columns are those of the forms.
inline Eigen::MatrixXd weighted_fields(const Mesh_view& mesh, const Eigen::MatrixXd& forms)
{
  const Eigen::ArrayXd roots = face_areas(mesh).array().sqrt();
  Eigen::MatrixXd columns(3 * mesh.size_of_faces(), forms.cols());
  for (Eigen::Index i = 0; i < forms.cols(); ++i) {
    const Points scaled = tangent_field(mesh, forms.col(i)) * roots.matrix().asDiagonal();
    columns.col(i) = scaled.reshaped();
  }
  return columns;
}

/// \throw Precondition_error if what was left of one form beside the others is nothing, or no
/// number
inline void require_independent(const Eigen::VectorXd& pivots)
{
  const double least_pivot = 1e-7;  // relative: half the digits
  if (!pivots.allFinite() || !(pivots.minCoeff() > least_pivot * pivots.maxCoeff()))
    throw Precondition_error("orthonormalize", "the 1-forms are not linearly independent");
}

/// Replaces closed forms by orthonormal ones that span the same. By fields, whose inner products
/// are positive definite also to rounding, which sums with negative cotan weights are not.
inline void orthonormalize(const Mesh_view& mesh, Eigen::MatrixXd& forms)
{
  if (forms.cols() == 0) return;
  for (int pass = 0; pass < 2; ++pass) {  // the second takes out the rounding of the first
    Eigen::MatrixXd V = weighted_fields(mesh, forms);
    Eigen::VectorXd pivots(V.cols());
    for (Eigen::Index j = 0; j < V.cols(); ++j) {
      for (Eigen::Index i = 0; i < j; ++i) {
        const double part = V.col(i).dot(V.col(j));
        V.col(j) -= part * V.col(i);
        forms.col(j) -= part * forms.col(i);
      }
      pivots[j] = V.col(j).norm();
      V.col(j) /= pivots[j];
      forms.col(j) /= pivots[j];
    }
    require_independent(pivots);
  }
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
