// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/conformal_energy.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Quaternionic_linear_algebra/algebra/stable_norm.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <array>
#include <cstddef>
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

namespace internal {

/// The energy of one face as a matrix for (a_0, b_0, a_1, b_1, a_2, b_2)
/// \param cosines of the angles between the normals of its corners and its own
Eigen::Matrix<double, 6, 6> vertex_normal_energy_of_face(const Mesh_view& mesh, int f,
                                                         const Eigen::Vector3d& cosines)
{
  Eigen::Matrix3d e;
  for (int c = 0; c < 3; ++c) e.col(c) = mesh.vector(3 * f + c);
  const Eigen::Matrix3d K = e.transpose() * e / (2 * mesh.double_area_vector(f).norm());
  Eigen::Matrix<double, 6, 6> E = Eigen::Matrix<double, 6, 6>::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      E(2 * i, 2 * j) = K(i, j);
      E(2 * i + 1, 2 * j + 1) = cosines[i] * cosines[j] * K(i, j);
    }
    const int next = (i + 1) % 3;  // area <J grad phi_i, grad phi_next> = 1/2
    E(2 * i, 2 * next + 1) = E(2 * next + 1, 2 * i) = -cosines[next] / 2;
    E(2 * next, 2 * i + 1) = E(2 * i + 1, 2 * next) = cosines[i] / 2;
  }
  return E;
}

}  // namespace internal

Hermitian_sparse_matrix<double> vertex_normal_energy(const Mesh_view& mesh, const Points& normals,
                                                     const Sparse_pattern& graph)
{
  auto pattern = std::make_shared<const Sparse_pattern>(expanded_pattern(graph, 2));
  Hermitian_sparse_matrix<double> L(pattern);
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const std::array<int, 3>& v = mesh.corners(f);
    const Eigen::Vector3d normal = stable_normalized(mesh.double_area_vector(f));
    Eigen::Vector3d cosines;
    for (int c = 0; c < 3; ++c)
      cosines[c] = normals.col(v[static_cast<std::size_t>(c)]).dot(normal);
    const auto E = internal::vertex_normal_energy_of_face(mesh, f, cosines);
    for (int r = 0; r < 6; ++r)
      for (int s = 0; s < 6; ++s) {
        const int i = 2 * v[static_cast<std::size_t>(r / 2)] + r % 2,
                  j = 2 * v[static_cast<std::size_t>(s / 2)] + s % 2;
        if (i >= j) L.value(pattern->find(i, j)) += E(r, s);
      }
  }
  return L;
}

}  // namespace Conformal_geometry_processing
