// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_AVERAGING_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_AVERAGING_H

#include <Conformal_geometry_processing/algebra/Quaternionic_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief B: |F| x |V|, the mean of the three corners of each face [CGP 5.3]. Dimensionless.
/// \param mesh must outlive the matrix
internal::Quaternionic_sparse_matrix<double> averaging(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/operators/averaging_impl.h>
#endif

#endif
