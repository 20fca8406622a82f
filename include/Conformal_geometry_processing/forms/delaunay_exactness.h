// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_DELAUNAY_EXACTNESS_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_DELAUNAY_EXACTNESS_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/forms/Exactness_constraints.h>
#include <Conformal_geometry_processing/forms/Harmonic_basis.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/delaunay_operators.h>
#include <Conformal_geometry_processing/operators/divergence.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <utility>

/// \file delaunay_exactness.h
/// \brief `Hodge_decomposition.h` and `Exactness_constraints.h` on a `Delaunay_view`.
namespace Conformal_geometry_processing {

namespace internal {

/// Replaces forms by orthonormal ones that span the same.
inline void orthonormalize(const Eigen::VectorXd& w, Eigen::MatrixXd& forms)
{
  Eigen::VectorXd pivots(forms.cols());
  if (forms.cols() == 0) return;
  for (int pass = 0; pass < 2; ++pass) {  // the second takes out the rounding of the first
    for (Eigen::Index j = 0; j < forms.cols(); ++j) {
      for (Eigen::Index i = 0; i < j; ++i)
        forms.col(j) -= w.cwiseProduct(forms.col(i)).dot(forms.col(j)) * forms.col(i);
      pivots[j] = std::sqrt(w.dot(forms.col(j).cwiseAbs2()));
      forms.col(j) /= pivots[j];
    }
    require_independent(pivots);
  }
}

}  // namespace internal

/// \ingroup PkgForms
/// \brief the harmonic forms in the classes of `mesh.forms()`, orthonormal; without fields.
///
/// Two solves for each of the k forms, and O(k^2 |E|). Weights are negative at the boundary only,
/// so that sums with them keep their digits, other than on a mesh that is not Delaunay.
/// \param laplacian solves with `cotan_laplacian(mesh)`
/// \throw Precondition_error if the forms are not independent
/// \throw Solver_error if the solver fails
template <class Laplacian>
Harmonic_basis harmonic_basis(const Delaunay_view& mesh, const Laplacian& laplacian)
{
  const Eigen::VectorXd& w = mesh.cotan_weights();
  Eigen::MatrixXd forms = mesh.forms();
  internal::remove_exact_parts(mesh, w, laplacian, forms);
  internal::orthonormalize(w, forms);
  internal::remove_exact_parts(mesh, w, laplacian, forms);
  return {std::move(forms), {}};
}

/// \ingroup PkgForms
/// the areas that belong to the values of rho: of vertices, or of the faces of the mesh, |V| or
/// |F|; of a face at least a millionth of the mean
inline Eigen::VectorXd curvature_areas(const Delaunay_view& mesh, Curvature_potential::On on)
{
  if (on == Curvature_potential::On::vertices) return vertex_areas(mesh);
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.size_of_faces());
  for (const Delaunay_view::Sheet& sheet : mesh.sheets())
    areas[sheet.face] += sheet.share * mesh.area(sheet.triangle);
  return areas.cwiseMax(1e-6 * areas.mean());
}

namespace internal {

/// \brief the functions z with <D y, rho> = sum_i A_i rho_i z_i for all rho, of the parts of D y:
/// |V| or |F| x 4, real part first
inline Eigen::MatrixX4d dirac_adjoint(const Delaunay_view& mesh, const Quaternion_vector<double>& y,
                                      Curvature_potential::On on)
{
  const Eigen::VectorXd areas = curvature_areas(mesh, on);
  Eigen::MatrixX4d z = Eigen::MatrixX4d::Zero(areas.size(), 4);
  for (const Delaunay_view::Sheet& sheet : mesh.sheets()) {
    Quaternion<double> image;  // of M D
    for (int c = 0; c < 3; ++c)
      image -= imaginary(sheet.edges.col(c).eval()) *
               y[mesh.corners(sheet.triangle)[static_cast<std::size_t>(c)]] / 2.;
    const Eigen::RowVector4d part =
        sheet.share * Eigen::RowVector4d(image.w, image.x, image.y, image.z);
    if (on == Curvature_potential::On::faces)
      z.row(sheet.face) += part;
    else
      for (const int v : mesh.corners(sheet.triangle)) z.row(v) += part / 3;
  }
  return areas.cwiseInverse().asDiagonal() * z;
}

}  // namespace internal

/// \ingroup PkgForms
/// \brief see `exactness_constraints()` of a mesh, `Exactness::adjoint`: three functions for each
/// form, |V| or |F| x 3k, and a solve for each form.
/// \param inverse solves with `dirac_energy()` for rho = 0
template <class Inverse>
Eigen::MatrixXd exactness_constraints(const Delaunay_view& mesh, const Harmonic_basis& basis,
                                      const Inverse& inverse, Curvature_potential::On on)
{
  const Block<Quaternion<double>> Y = inverse(internal::adjoint_sources(mesh, basis));
  Eigen::MatrixXd z(curvature_areas(mesh, on).size(), 3 * basis.size());
  for (Eigen::Index i = 0; i < Y.cols(); ++i)
    z.middleCols<3>(3 * i) = internal::dirac_adjoint(mesh, Y.col(i), on).rightCols<3>();
  return z;
}

/// \ingroup PkgForms
/// see `bounded_exactness_constraints()` of a mesh: |V| or |F| x 3k, and 3k solves
template <class Inverse>
Eigen::MatrixXd bounded_exactness_constraints(const Delaunay_view& mesh,
                                              const Harmonic_basis& basis, const Inverse& inverse,
                                              Curvature_potential::On on)
{
  const Block<Quaternion<double>> Y =
      inverse(internal::sources_along_axes(internal::adjoint_sources(mesh, basis)));
  Eigen::MatrixXd z(curvature_areas(mesh, on).size(), Y.cols());
  for (Eigen::Index i = 0; i < Y.cols(); ++i)
    z.col(i) = internal::dirac_adjoint(mesh, Y.col(i), on).col(0);
  return z;
}

}  // namespace Conformal_geometry_processing

#endif
