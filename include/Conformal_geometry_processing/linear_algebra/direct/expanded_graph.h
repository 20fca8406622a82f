// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_EXPANDED_GRAPH_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_EXPANDED_GRAPH_H

#include <Conformal_geometry_processing/algebra/Sparse_pattern.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief the pattern of matrices whose entry (i, j) is a block of `width` x `width` numbers, where
/// `pattern` is that of the blocks.
///
/// For matrices on the vertices of a mesh that are real-linear but not quaternionic: of width 4,
/// factored by `Supernodal_cholesky<double>` with the `expanded_ordering()`. Vertex i has the rows
/// width i ... width i + width - 1.
Sparse_pattern expanded_pattern(const Sparse_pattern& pattern, int width);

/// \ingroup PkgLinearAlgebra
/// \brief an ordering of vertices as one of the rows of their blocks, which stay together.
///
/// As good as an ordering of the larger graph, which takes `width` squared times as long to find.
Ordering expanded_ordering(const Ordering& order, int width);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/expanded_graph_impl.h>
#endif

#endif
