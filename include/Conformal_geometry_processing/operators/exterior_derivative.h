// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// d0: |E| x |V|, the difference along each edge i -> j, i < j; the kernel of a connected mesh
/// consists of the constants [CGP 5.6]
Eigen::SparseMatrix<double, Eigen::RowMajor> exterior_derivative_0(const Mesh_view& mesh);

/// \ingroup PkgOperators
/// d1: |F| x |E|, the circulation around each face; d1 d0 = 0 exactly [CGP 5.6]
Eigen::SparseMatrix<double, Eigen::RowMajor> exterior_derivative_1(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing
