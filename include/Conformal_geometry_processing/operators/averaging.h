// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternionic_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief B: |F| x |V|, the mean of the three corners of each face [CGP 5.3]. Dimensionless.
/// \param mesh must outlive the matrix
internal::Quaternionic_sparse_matrix<double> averaging(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing
