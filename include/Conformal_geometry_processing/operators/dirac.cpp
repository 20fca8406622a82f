// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/dirac.h>

namespace Conformal_geometry_processing {

internal::Quaternionic_sparse_matrix<double> dirac(const Mesh_view& mesh)
{
  internal::Quaternionic_sparse_matrix<double> D(mesh.corners(), mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double double_area = mesh.double_area_vector(f).norm();
    for (int c = 0; c < 3; ++c) D.value(f, c) = imaginary(mesh.vector(3 * f + c)) / -double_area;
  }
  return D;
}

internal::Quaternionic_sparse_matrix<double> averaging(const Mesh_view& mesh)
{
  internal::Quaternionic_sparse_matrix<double> B(mesh.corners(), mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int c = 0; c < 3; ++c) B.value(f, c) = {1. / 3, 0, 0, 0};
  return B;
}

}  // namespace Conformal_geometry_processing
