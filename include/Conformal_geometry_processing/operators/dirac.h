// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Quaternionic_sparse_matrix.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief D: |F| x |V|, the discrete quaternionic Dirac operator [CGP (5.1)].
///
/// (D lambda)_f = -1/(2 A_f) sum_c e_c lambda_c, where e_c is the edge opposite corner c, oriented
/// counter-clockwise. D f = -2 N on every face, constants are in the kernel, and B^H M_F D is
/// Hermitian on a closed surface. In 1/length.
/// \param mesh must outlive the matrix
/// \pre no face has area zero
internal::Quaternionic_sparse_matrix<double> dirac(const Mesh_view& mesh);

/// \ingroup PkgOperators
/// \brief B: |F| x |V|, the mean of the three corners of each face [CGP 5.3]. Dimensionless.
/// \param mesh must outlive the matrix
internal::Quaternionic_sparse_matrix<double> averaging(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing
