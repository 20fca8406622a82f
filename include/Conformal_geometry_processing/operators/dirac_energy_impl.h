// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_ENERGY_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_ENERGY_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE void assemble_dirac_energy(const Mesh_view& mesh, const Curvature_potential& rho,
                                      Hermitian_sparse_matrix<Quaternion<double>>& X)
{
  X.set_zero();
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double A = mesh.double_area_vector(f).norm() / 2;
    const Eigen::Vector3d r = rho.at_corners(mesh, f);
    Quaternion<double> e[3];
    for (int c = 0; c < 3; ++c) e[c] = imaginary(mesh.vector(3 * f + c));
    const auto entry = [&](int i, int j) {
      Quaternion<double> x = (r[i] * e[j] - r[j] * e[i]) / 6. - e[i] * e[j] / (4 * A);
      x.w += A * r[i] * r[j] / 9;
      return x;
    };
    for (int c = 0; c < 3; ++c) {
      const int i = (c + 1) % 3, j = (c + 2) % 3, h = 3 * f + c;  // h runs from i to j
      X.value(diagonal_position(X.pattern(), mesh.from(h))).w += entry(i, i).w;
      X.value(edge_position(mesh, mesh.edge(h))) +=
          mesh.from(h) > mesh.to(h) ? entry(i, j) : entry(j, i);  // the row is the larger number
    }
  }
}

CGP_INLINE Hermitian_sparse_matrix<Quaternion<double>> dirac_energy(const Mesh_view& mesh,
                                                                    const Curvature_potential& rho)
{
  Hermitian_sparse_matrix<Quaternion<double>> X(vertex_graph(mesh));
  assemble_dirac_energy(mesh, rho, X);
  return X;
}

CGP_INLINE Hermitian_sparse_matrix<Quaternion<double>> dirac_form(const Mesh_view& mesh,
                                                                  const Curvature_potential& rho)
{
  Hermitian_sparse_matrix<Quaternion<double>> K(vertex_graph(mesh));
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double A = mesh.double_area_vector(f).norm() / 2;
    const Quaternion<double> r{A * rho.values[f] / 9, 0, 0, 0};
    for (int c = 0; c < 3; ++c) {
      const int h = 3 * f + c, i = mesh.from(h), j = mesh.to(h);
      const int column = i > j ? (c + 2) % 3 : (c + 1) % 3;  // the corner of the smaller number
      K.value(diagonal_position(K.pattern(), i)) -= r;
      K.value(edge_position(mesh, mesh.edge(h))) -= imaginary(mesh.vector(3 * f + column)) / 6. + r;
    }
  }
  return K;
}

}  // namespace Conformal_geometry_processing

#endif
