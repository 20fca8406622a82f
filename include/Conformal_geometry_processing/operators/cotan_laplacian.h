// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_COTAN_LAPLACIAN_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_COTAN_LAPLACIAN_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// the cotangent of the angle opposite halfedge h, that is of face h / 3 at its corner h % 3
inline double cotangent(const Mesh_view& mesh, int h)
{
  const Eigen::Vector3d a = mesh.vector(Mesh_view::next_in_face(h));
  const Eigen::Vector3d b = mesh.vector(Mesh_view::previous_in_face(h));
  return -a.dot(b) / a.cross(b).norm();
}

/// \ingroup PkgOperators
/// w = (cot alpha + cot beta) / 2 for each edge, one cotangent only at the boundary; |E| numbers,
/// negative where alpha + beta > pi. The Hodge star on 1-forms [CGP 5.6].
inline Eigen::VectorXd cotan_weights(const Mesh_view& mesh)
{
  Eigen::VectorXd w = Eigen::VectorXd::Zero(mesh.size_of_edges());
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) w[mesh.edge(h)] += cotangent(mesh, h) / 2;
  return w;
}

/// \ingroup PkgOperators
/// \brief writes the values of L = d0^T diag(w) d0 into a matrix on `vertex_graph(mesh)`.
/// \param w one weight for each edge, as `cotan_weights(mesh)` gives them
inline void assemble_cotan_laplacian(const Mesh_view& mesh, const Eigen::VectorXd& w,
                                     Hermitian_sparse_matrix<double>& L)
{
  L.set_zero();
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    L.value(edge_position(mesh, k)) = -w[k];
    for (int v : mesh.ends(k)) L.value(diagonal_position(L.pattern(), v)) += w[k];
  }
}

/// \ingroup PkgOperators
/// \brief L = d0^T diag(w) d0 on a given pattern [CGP 5.6].
///
/// |V| x |V|, real symmetric, positive *semidefinite* also where weights are negative; the kernel
/// of a connected mesh are the constants. (L f)_i = sum_j w_ij (f_i - f_j). Dimensionless.
inline Hermitian_sparse_matrix<double> cotan_laplacian(
    const Mesh_view& mesh, std::shared_ptr<const Sparse_pattern> pattern)
{
  Hermitian_sparse_matrix<double> L(std::move(pattern));
  assemble_cotan_laplacian(mesh, cotan_weights(mesh), L);
  return L;
}

/// \ingroup PkgOperators
/// L on a pattern of its own
inline Hermitian_sparse_matrix<double> cotan_laplacian(const Mesh_view& mesh)
{
  return cotan_laplacian(mesh, vertex_graph(mesh));
}

}  // namespace Conformal_geometry_processing

#endif
