// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>
#include <memory>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief d0 u, |E| x k, of k functions given as columns: u_j - u_i along each edge i -> j.
/// \param u |V| x k
inline Eigen::MatrixXd differential(const Surface_ref& surface, const Eigen::MatrixXd& u)
{
  Eigen::MatrixXd du(surface.size_of_edges(), u.cols());
  for (int k = 0; k < surface.size_of_edges(); ++k)
    du.row(k) = u.row(surface.ends(k)[1]) - u.row(surface.ends(k)[0]);
  return du;
}

/// \ingroup PkgOperators
/// \brief d0^T diag(w) omega, |V| x k, of k 1-forms given as one row of `omega` per edge i -> j.
///
/// Row i is the sum of w_ij omega over the edges *into* i minus the edges out of it. [CGP 5.6]
/// calls this the divergence; it is *minus* the usual one, to match the positive semidefinite L:
/// codifferential(d0 f) = L f. Columns sum to zero.
/// \param w `cotan_weights(surface)`, |E| \param omega |E| x k
template <class Derived>
Eigen::Matrix<double, Eigen::Dynamic, Derived::ColsAtCompileTime> codifferential(
    const Surface_ref& surface, const Eigen::VectorXd& w, const Eigen::MatrixBase<Derived>& omega)
{
  Eigen::Matrix<double, Eigen::Dynamic, Derived::ColsAtCompileTime> sum(surface.size_of_vertices(),
                                                                        omega.cols());
  sum.setZero();
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    sum.row(surface.ends(k)[0]) -= w[k] * omega.row(k);
    sum.row(surface.ends(k)[1]) += w[k] * omega.row(k);
  }
  return sum;
}

/// \ingroup PkgOperators
/// the cotangent of the angle of a sheet's triangle at corner c
double cotangent(const Sheet& sheet, int c);

/// \ingroup PkgOperators
/// the cotangent of the angle opposite halfedge h, which is at corner h % 3 of face h / 3
double cotangent(const Mesh_view& mesh, int h);

/// \ingroup PkgOperators
/// w = (cot alpha + cot beta) / 2 for each edge, with only one cotangent at the boundary; |E|
/// numbers, negative if alpha + beta > pi. The Hodge star on 1-forms [CGP 5.6].
Eigen::VectorXd cotan_weights(const Surface_ref& surface);

/// \ingroup PkgOperators
/// \brief writes the values of L = d0^T diag(w) d0 into a matrix on `vertex_graph(surface)`.
/// \param w one weight for each edge, as `cotan_weights(surface)` gives them
void assemble_cotan_laplacian(const Surface_ref& surface, const Eigen::VectorXd& w,
                              Hermitian_sparse_matrix<double>& L);

/// \ingroup PkgOperators
/// \brief L = d0^T diag(w) d0 on a given pattern [CGP 5.6].
///
/// |V| x |V|, real symmetric, positive *semidefinite* even if weights are negative; the kernel of a
/// connected surface consists of the constants. (L f)_i = sum_j w_ij (f_i - f_j). Dimensionless.
/// On irregular meshes it converges in the weak sense only: <g, L f> and solutions of L u = b do,
/// single values (L f)_i over the area of the vertex do not, as with `mean_curvature()`.
Hermitian_sparse_matrix<double> cotan_laplacian(const Surface_ref& surface,
                                                std::shared_ptr<const Sparse_pattern> pattern);

/// \ingroup PkgOperators
/// L on a new pattern
Hermitian_sparse_matrix<double> cotan_laplacian(const Surface_ref& surface);

}  // namespace Conformal_geometry_processing
