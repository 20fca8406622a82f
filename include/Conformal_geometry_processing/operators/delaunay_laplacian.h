// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DELAUNAY_LAPLACIAN_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DELAUNAY_LAPLACIAN_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// the pattern of every Hermitian matrix on the vertices, |V| x |V|: the diagonal,
/// and each pair of different vertices that an edge of the triangulation joins; |E| log |E|
inline std::shared_ptr<const Sparse_pattern> vertex_graph(const Delaunay_view& mesh)
{
  std::vector<std::pair<int, int>> entries;  // column, row
  for (int v = 0; v < mesh.size_of_vertices(); ++v) entries.emplace_back(v, v);
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    entries.emplace_back(mesh.ends(k)[0], mesh.ends(k)[1]);
  std::sort(entries.begin(), entries.end());
  entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
  auto pattern = std::make_shared<Sparse_pattern>();
  pattern->offsets.assign(static_cast<std::size_t>(mesh.size_of_vertices()) + 1, 0);
  for (const auto& [column, row] : entries) {
    ++pattern->offsets[static_cast<std::size_t>(column) + 1];
    pattern->indices.push_back(row);
  }
  for (std::size_t v = 1; v < pattern->offsets.size(); ++v)
    pattern->offsets[v] += pattern->offsets[v - 1];
  return pattern;
}

/// \ingroup PkgOperators
/// half the sum of the cotangents opposite each edge of the triangulation, |E|, see
/// `Delaunay_view::cotan_weights()`
inline const Eigen::VectorXd& cotan_weights(const Delaunay_view& mesh)
{
  return mesh.cotan_weights();
}

/// \ingroup PkgOperators
/// \brief writes the values of L = d0^T diag(w) d0 into a matrix on `vertex_graph(mesh)`.
/// \param w one weight for each edge, as `cotan_weights(mesh)` gives them
inline void assemble_cotan_laplacian(const Delaunay_view& mesh, const Eigen::VectorXd& w,
                                     Hermitian_sparse_matrix<double>& L)
{
  L.set_zero();
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const auto [i, j] = mesh.ends(k);
    if (i == j) continue;
    L.value(L.pattern().find(j, i)) -= w[k];
    for (const int v : {i, j}) L.value(L.pattern().find(v, v)) += w[k];
  }
}

/// \ingroup PkgOperators
/// \brief L, the intrinsic Delaunay Laplacian [Bobenko and Springborn 2007]: |V| x |V|, real,
/// positive semidefinite, with no positive entry off the diagonal but at the boundary and at caps
/// there; the kernel of a connected surface are the constants.
inline Hermitian_sparse_matrix<double> cotan_laplacian(
    const Delaunay_view& mesh, std::shared_ptr<const Sparse_pattern> pattern)
{
  Hermitian_sparse_matrix<double> L(std::move(pattern));
  assemble_cotan_laplacian(mesh, cotan_weights(mesh), L);
  return L;
}

}  // namespace Conformal_geometry_processing

#endif
