// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_H

#include <Conformal_geometry_processing/algebra/Quaternionic_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief D: |F| x |V|, the discrete quaternionic Dirac operator [CGP (5.1)].
///
/// (D lambda)_f = -1/(2 A_f) sum_c e_c lambda_c, where e_c is the edge opposite corner c, run
/// through counter-clockwise. D f = -2 N on every face, constants are in the kernel, and B^H M_F D
/// is Hermitian on a closed surface. In 1/length.
/// \param mesh must outlive the matrix
/// \pre no face has area zero
inline Quaternionic_sparse_matrix<double> dirac(const Mesh_view& mesh)
{
  Quaternionic_sparse_matrix<double> D(mesh.corners(), mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double double_area = mesh.double_area_vector(f).norm();
    for (int c = 0; c < 3; ++c) D.value(f, c) = imaginary(mesh.vector(3 * f + c)) / -double_area;
  }
  return D;
}

}  // namespace Conformal_geometry_processing

#endif
