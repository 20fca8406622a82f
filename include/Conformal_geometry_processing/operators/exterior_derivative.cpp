// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/exterior_derivative.h>

namespace Conformal_geometry_processing {

Eigen::SparseMatrix<double, Eigen::RowMajor> exterior_derivative_0(const Mesh_view& mesh)
{
  Eigen::SparseMatrix<double, Eigen::RowMajor> d(mesh.size_of_edges(), mesh.size_of_vertices());
  d.reserve(Eigen::VectorXi::Constant(mesh.size_of_edges(), 2));
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    d.insert(k, mesh.ends(k)[0]) = -1;
    d.insert(k, mesh.ends(k)[1]) = 1;
  }
  d.makeCompressed();
  return d;
}

Eigen::SparseMatrix<double, Eigen::RowMajor> exterior_derivative_1(const Mesh_view& mesh)
{
  Eigen::SparseMatrix<double, Eigen::RowMajor> d(mesh.size_of_faces(), mesh.size_of_edges());
  d.reserve(Eigen::VectorXi::Constant(mesh.size_of_faces(), 3));
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    d.insert(Mesh_view::face(h), mesh.edge(h)) = mesh.from(h) < mesh.to(h) ? 1 : -1;
  d.makeCompressed();
  return d;
}

}  // namespace Conformal_geometry_processing
