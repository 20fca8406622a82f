// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/averaging.h>

namespace Conformal_geometry_processing {

internal::Quaternionic_sparse_matrix<double> averaging(const Mesh_view& mesh)
{
  internal::Quaternionic_sparse_matrix<double> B(mesh.corners(), mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int c = 0; c < 3; ++c) B.value(f, c) = {1. / 3, 0, 0, 0};
  return B;
}

}  // namespace Conformal_geometry_processing
