// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_COTAN_LAPLACIAN_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_COTAN_LAPLACIAN_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

#include <memory>

namespace Conformal_geometry_processing {

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

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/operators/cotan_laplacian_impl.h>
#endif

#endif
