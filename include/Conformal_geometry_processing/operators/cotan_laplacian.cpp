// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>

#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <utility>

namespace Conformal_geometry_processing {

double cotangent(const Sheet& sheet, int c)
{
  return -sheet.vectors.col((c + 1) % 3).dot(sheet.vectors.col((c + 2) % 3)) / (2 * sheet.area);
}

double cotangent(const Mesh_view& mesh, int h)
{
  return cotangent(mesh.sheet(h / 3), h % 3);
}

Eigen::VectorXd cotan_weights(const Surface_ref& surface)
{
  Eigen::VectorXd w = Eigen::VectorXd::Zero(surface.size_of_edges());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    for (int c = 0; c < 3; ++c) {
      const int k = sheet.edges[static_cast<std::size_t>(c)];
      if (k >= 0) w[k] += sheet.share * cotangent(sheet, c) / 2;
    }
  }
  return w;
}

void assemble_cotan_laplacian(const Surface_ref& surface, const Eigen::VectorXd& w,
                              Hermitian_sparse_matrix<double>& L)
{
  L.set_zero();
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    const auto [i, j] = surface.ends(k);
    if (i == j) continue;
    L.value(internal::entry_position(L.pattern(), j, i, k)) -= w[k];
    for (const int v : {i, j}) L.value(diagonal_position(L.pattern(), v)) += w[k];
  }
}

Hermitian_sparse_matrix<double> cotan_laplacian(const Surface_ref& surface,
                                                std::shared_ptr<const Sparse_pattern> pattern)
{
  Hermitian_sparse_matrix<double> L(std::move(pattern));
  assemble_cotan_laplacian(surface, cotan_weights(surface), L);
  return L;
}

Hermitian_sparse_matrix<double> cotan_laplacian(const Surface_ref& surface)
{
  return cotan_laplacian(surface, vertex_graph(surface));
}

}  // namespace Conformal_geometry_processing
