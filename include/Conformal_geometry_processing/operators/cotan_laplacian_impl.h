// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_COTAN_LAPLACIAN_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_COTAN_LAPLACIAN_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

CGP_INLINE double cotangent(const Mesh_view& mesh, int h)
{
  const Eigen::Vector3d a = mesh.vector(Mesh_view::next_in_face(h));
  const Eigen::Vector3d b = mesh.vector(Mesh_view::previous_in_face(h));
  return -a.dot(b) / a.cross(b).norm();
}

CGP_INLINE Eigen::VectorXd cotan_weights(const Mesh_view& mesh)
{
  Eigen::VectorXd w = Eigen::VectorXd::Zero(mesh.size_of_edges());
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) w[mesh.edge(h)] += cotangent(mesh, h) / 2;
  return w;
}

CGP_INLINE void assemble_cotan_laplacian(const Mesh_view& mesh, const Eigen::VectorXd& w,
                                         Hermitian_sparse_matrix<double>& L)
{
  L.set_zero();
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    L.value(edge_position(mesh, k)) = -w[k];
    for (int v : mesh.ends(k)) L.value(diagonal_position(L.pattern(), v)) += w[k];
  }
}

CGP_INLINE Hermitian_sparse_matrix<double> cotan_laplacian(
    const Mesh_view& mesh, std::shared_ptr<const Sparse_pattern> pattern)
{
  Hermitian_sparse_matrix<double> L(std::move(pattern));
  assemble_cotan_laplacian(mesh, cotan_weights(mesh), L);
  return L;
}

CGP_INLINE Hermitian_sparse_matrix<double> cotan_laplacian(const Mesh_view& mesh)
{
  return cotan_laplacian(mesh, vertex_graph(mesh));
}

}  // namespace Conformal_geometry_processing

#endif
