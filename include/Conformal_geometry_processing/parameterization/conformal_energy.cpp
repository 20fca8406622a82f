// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/conformal_energy.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

#include <complex>
#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

Hermitian_sparse_matrix<std::complex<double>> conformal_energy(
    const Mesh_view& mesh, std::shared_ptr<const Sparse_pattern> pattern)
{
  Hermitian_sparse_matrix<std::complex<double>> L(std::move(pattern));
  const Eigen::VectorXd w = cotan_weights(mesh);
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    L.value(L.pattern().find(mesh.ends(k)[1], mesh.ends(k)[0])) -= w[k];
    for (const int v : mesh.ends(k)) L.value(diagonal_position(L.pattern(), v)) += w[k];
  }
  // Twice the area is the sum of Im(conjugate(z_i) z_j) along the boundary; row i gets i/2.
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0)
      L.value(L.pattern().find(mesh.ends(mesh.edge(h))[1], mesh.ends(mesh.edge(h))[0])) +=
          std::complex<double>(0, mesh.from(h) > mesh.to(h) ? 0.5 : -0.5);
  return L;
}

Hermitian_sparse_matrix<std::complex<double>> conformal_energy(const Mesh_view& mesh)
{
  return conformal_energy(mesh, vertex_graph(mesh));
}

}  // namespace Conformal_geometry_processing
