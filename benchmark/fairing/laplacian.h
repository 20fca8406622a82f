// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// L f for each coordinate of f, without a matrix; 3 x |V|
/// \param w the cotan weight of each edge
inline CGP::Points laplacian(const CGP::Mesh_view& mesh, const Eigen::VectorXd& w,
                             const CGP::Points& f)
{
  CGP::Points Lf = CGP::Points::Zero(3, f.cols());
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const auto [i, j] = mesh.ends(k);
    const Eigen::Vector3d flow = w[k] * (f.col(i) - f.col(j));
    Lf.col(i) += flow;
    Lf.col(j) -= flow;
  }
  return Lf;
}

/// M f, with the diagonal of M
inline CGP::Points weighted(const Eigen::VectorXd& M, const CGP::Points& f)
{
  return f.array().rowwise() * M.transpose().array();
}

/// M + t L in the memory of A, a matrix on `vertex_graph(mesh)`
inline void assemble_implicit_step(const CGP::Mesh_view& mesh, const Eigen::VectorXd& M, double t,
                                   const Eigen::VectorXd& w,
                                   CGP::Hermitian_sparse_matrix<double>& A)
{
  CGP::assemble_cotan_laplacian(mesh, t * w, A);
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    A.value(CGP::diagonal_position(A.pattern(), v)) += M[v];
}

}  // namespace cgp_benchmark
