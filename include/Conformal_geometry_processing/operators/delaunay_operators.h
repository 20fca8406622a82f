// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DELAUNAY_OPERATORS_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DELAUNAY_OPERATORS_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/operators/delaunay_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

/// \file delaunay_operators.h
/// \brief the operators of `dirac_energy.h`, `dirac_forms.h`, `cotan_laplacian.h` and
/// `mass_matrices.h` on a `Delaunay_view`: the same ones where the mesh is Delaunay, and bounded
/// however thin its faces are.
namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// one third of the areas of the triangles around each vertex, |V|
inline Eigen::VectorXd vertex_areas(const Delaunay_view& mesh)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int t = 0; t < mesh.size_of_triangles(); ++t)
    for (const int v : mesh.corners(t)) areas[v] += mesh.area(t) / 3;
  return areas;
}

/// \ingroup PkgOperators
/// the areas of the triangles of the view, as many as there are of them (not of faces of the mesh)
inline Eigen::VectorXd face_areas(const Delaunay_view& mesh)
{
  Eigen::VectorXd areas(mesh.size_of_triangles());
  for (int t = 0; t < mesh.size_of_triangles(); ++t) areas[t] = mesh.area(t);
  return areas;
}

/// \ingroup PkgOperators
/// rho = 0, on the vertices
inline Curvature_potential no_potential(const Delaunay_view& mesh)
{
  return Curvature_potential::on_vertices(Eigen::VectorXd::Zero(mesh.size_of_vertices()));
}

namespace internal {

/// adds `entry(i, j)`, which is Hermitian in the corners i and j of a triangle, to a matrix
template <class Scalar, class Entry>
void add_triangle(const std::array<int, 3>& corners, Entry entry,
                  Hermitian_sparse_matrix<Scalar>& A)
{
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int row = corners[static_cast<std::size_t>(i)],
                column = corners[static_cast<std::size_t>(j)];
      if (row >= column) A.value(A.pattern().find(row, column)) += entry(i, j);
    }
}

/// rho at the corners of a sheet
inline Eigen::Vector3d potential_at(const Delaunay_view& mesh, const Delaunay_view::Sheet& sheet,
                                    const Curvature_potential& rho)
{
  if (rho.on == Curvature_potential::On::faces)
    return Eigen::Vector3d::Constant(rho.values[sheet.face]);
  const auto& v = mesh.corners(sheet.triangle);
  return {rho.values[v[0]], rho.values[v[1]], rho.values[v[2]]};
}

}  // namespace internal

/// \ingroup PkgOperators
/// \brief assembles X = (D - R)^H M (D - R) over the sheets: the energy, on the faces of the mesh,
/// of spins that are linear on the Delaunay triangles.
///
/// Each sheet adds its share of what `assemble_dirac_energy()` adds for a face. So X is positive
/// semidefinite for every rho; for rho = 0 its real part is the intrinsic Delaunay Laplacian, its
/// imaginary part bounded by 1 per entry and triangle, and the constants are in its kernel. The
/// thesis's own matrix grows as one over the height of a cap [CGP Alg. 2].
/// \param X a matrix on `vertex_graph(mesh)`; its values are replaced
inline void assemble_dirac_energy(const Delaunay_view& mesh, const Curvature_potential& rho,
                                  Hermitian_sparse_matrix<Quaternion<double>>& X)
{
  X.set_zero();
  for (const Delaunay_view::Sheet& sheet : mesh.sheets()) {
    const double A = mesh.area(sheet.triangle);
    const Eigen::Vector3d r = internal::potential_at(mesh, sheet, rho);
    Quaternion<double> e[3];
    for (int c = 0; c < 3; ++c) e[c] = imaginary(sheet.edges.col(c).eval());
    const auto entry = [&](int i, int j) {
      Quaternion<double> x = (r[i] * e[j] - r[j] * e[i]) / 6. - e[i] * e[j] / (4 * A);
      x.w += A * r[i] * r[j] / 9;
      return x * sheet.share;
    };
    internal::add_triangle(mesh.corners(sheet.triangle), entry, X);
  }
}

/// \ingroup PkgOperators
/// X on a pattern of its own
inline Hermitian_sparse_matrix<Quaternion<double>> dirac_energy(const Delaunay_view& mesh,
                                                                const Curvature_potential& rho)
{
  Hermitian_sparse_matrix<Quaternion<double>> X(vertex_graph(mesh));
  assemble_dirac_energy(mesh, rho, X);
  return X;
}

namespace internal {

/// entry (i, j) of what a sheet adds to the Hermitian part of B^H M (D - R)
/// \param A the area of its triangle \param r `potential_at()`
inline Quaternion<double> form_entry(const Delaunay_view::Sheet& sheet, double A,
                                     const Eigen::Vector3d& r, int i, int j)
{
  Quaternion<double> k = imaginary(((sheet.edges.col(i) - sheet.edges.col(j)) / 12).eval());
  k.w = -A * (r[i] + r[j]) / 18;
  return k * sheet.share;
}

}  // namespace internal

/// \ingroup PkgOperators
/// \brief the Hermitian part of B^H M (D - R), |V| x |V|, indefinite, in units of length.
inline Hermitian_sparse_matrix<Quaternion<double>> dirac_form(const Delaunay_view& mesh,
                                                              const Curvature_potential& rho)
{
  Hermitian_sparse_matrix<Quaternion<double>> K(vertex_graph(mesh));
  for (const Delaunay_view::Sheet& sheet : mesh.sheets()) {
    const double A = mesh.area(sheet.triangle);
    const Eigen::Vector3d r = internal::potential_at(mesh, sheet, rho);
    const auto entry = [&](int i, int j) { return internal::form_entry(sheet, A, r, i, j); };
    internal::add_triangle(mesh.corners(sheet.triangle), entry, K);
  }
  return K;
}

/// \ingroup PkgOperators
/// \brief the form `dirac` as an operator on one vector, without assembling a matrix
inline Quaternion_vector<double> apply_dirac_form(const Delaunay_view& mesh,
                                                  const Curvature_potential& rho,
                                                  const Quaternion_vector<double>& lambda)
{
  Quaternion_vector<double> result = Quaternion_vector<double>::Constant(lambda.size(), {});
  for (const Delaunay_view::Sheet& sheet : mesh.sheets()) {
    const double A = mesh.area(sheet.triangle);
    const Eigen::Vector3d r = internal::potential_at(mesh, sheet, rho);
    const auto& v = mesh.corners(sheet.triangle);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        result[v[static_cast<std::size_t>(i)]] +=
            internal::form_entry(sheet, A, r, i, j) * lambda[v[static_cast<std::size_t>(j)]];
  }
  return result;
}

/// \ingroup PkgOperators
/// see `dirac_forms()` of a mesh
inline Dirac_forms dirac_forms(const Delaunay_view& mesh, const Curvature_potential& rho,
                               const Block<Quaternion<double>>& vectors)
{
  const Eigen::Index k = vectors.cols();
  Block<Quaternion<double>> images(vectors.rows(), k);
  for (Eigen::Index a = 0; a < k; ++a) images.col(a) = apply_dirac_form(mesh, rho, vectors.col(a));
  Dirac_forms forms{gram_matrix(vectors, images), Block<Quaternion<double>>(k, k)};
  for (int t = 0; t < mesh.size_of_triangles(); ++t)
    for (Eigen::Index a = 0; a < k; ++a)
      for (Eigen::Index b = 0; b < k; ++b) {
        Quaternion<double> left, right;  // sums over the corners
        for (const int v : mesh.corners(t)) {
          left += vectors(v, a);
          right += vectors(v, b);
        }
        forms.mass(a, b) += mesh.area(t) / 9 * (conjugate(left) * right);
      }
  return forms;
}

/// \ingroup PkgOperators
/// see `dirac_quotient()` of a mesh
inline double dirac_quotient(const Delaunay_view& mesh, const Curvature_potential& rho,
                             const Quaternion_vector<double>& lambda)
{
  const Dirac_forms forms = dirac_forms(mesh, rho, lambda);
  return forms.dirac(0, 0).w / forms.mass(0, 0).w;
}

/// \ingroup PkgOperators
/// see `dirac_misfit()` of a mesh
inline double dirac_misfit(const Delaunay_view& mesh, const Curvature_potential& rho,
                           const Quaternion_vector<double>& lambda)
{
  double energy = 0;
  for (const Delaunay_view::Sheet& sheet : mesh.sheets()) {
    const double A = mesh.area(sheet.triangle);
    const Eigen::Vector3d r = internal::potential_at(mesh, sheet, rho);
    Quaternion<double> image;  // of M (D - R)
    for (int c = 0; c < 3; ++c) {
      const auto& l = lambda[mesh.corners(sheet.triangle)[static_cast<std::size_t>(c)]];
      image -= imaginary(sheet.edges.col(c).eval()) * l / 2. + (A * r[c] / 3) * l;
    }
    energy += sheet.share * squared_norm(image) / A;
  }
  double mass = 0;
  const Eigen::VectorXd areas = vertex_areas(mesh);
  for (Eigen::Index v = 0; v < areas.size(); ++v) mass += areas[v] * squared_norm(lambda[v]);
  return std::sqrt(energy / mass);
}

}  // namespace Conformal_geometry_processing

#endif
