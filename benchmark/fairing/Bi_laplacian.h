// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

#include "Rank_one_sum.h"

namespace cgp_benchmark {

/// M + t L M^-1 L of a surface that moves, as the sum over the vertices of squares of rows of L
class Bi_laplacian {
 public:
  explicit Bi_laplacian(const CGP::Mesh_view& mesh) : m_sum(mesh.size_of_vertices(), rows(mesh)) {}

  const CGP::Sparse_pattern& pattern() const { return m_sum.pattern(); }

  /// \param M areas of the vertices \param weights cotan weights of the edges
  const CGP::Hermitian_sparse_matrix<double>& assemble(const Eigen::VectorXd& M, double t,
                                                       const Eigen::VectorXd& weights)
  {
    std::vector<double> coefficients(m_edges.size());
    std::size_t own = 0;
    for (std::size_t p = 0; p < m_edges.size(); ++p) {
      if (m_edges[p] < 0) {
        own = p;
        continue;
      }
      coefficients[p] = -weights[m_edges[p]];
      coefficients[own] += weights[m_edges[p]];
    }
    return m_sum.assemble(M, t * M.cwiseInverse(), coefficients);
  }

 private:
  /// each vertex with its neighbours; notes the edges to them
  Stencils rows(const CGP::Mesh_view& mesh)
  {
    std::vector<std::vector<int>> edges(static_cast<std::size_t>(mesh.size_of_vertices()));
    for (int k = 0; k < mesh.size_of_edges(); ++k)
      for (const int v : mesh.ends(k)) edges[static_cast<std::size_t>(v)].push_back(k);
    Stencils stencils;
    for (int v = 0; v < mesh.size_of_vertices(); ++v) {
      stencils.vertices.push_back(v);
      m_edges.push_back(-1);
      for (const int k : edges[static_cast<std::size_t>(v)]) {
        stencils.vertices.push_back(mesh.ends(k)[0] + mesh.ends(k)[1] - v);
        m_edges.push_back(k);
      }
      stencils.close();
    }
    return stencils;
  }

  std::vector<int> m_edges;  // to each vertex of each stencil; -1 for the one in the middle
  Rank_one_sum m_sum;
};

}  // namespace cgp_benchmark
