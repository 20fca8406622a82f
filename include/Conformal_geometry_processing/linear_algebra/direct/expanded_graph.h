// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Returns the pattern of matrices with blocks of `width` x `width` numbers as entries,
/// where `pattern` is the pattern of the blocks.
///
/// For matrices on the vertices of a mesh that are real-linear but not quaternionic: of width 4,
/// factored by `Supernodal_cholesky<double>` with the `expanded_ordering()`. Vertex i has the rows
/// width i ... width i + width - 1.
Sparse_pattern expanded_pattern(const Sparse_pattern& pattern, int width);

/// \ingroup PkgLinearAlgebra
/// \brief Expands an ordering of vertices to the rows of their blocks, which stay contiguous.
///
/// As good as an ordering of the larger graph, whose computation takes `width` squared times as
/// long.
internal::Ordering expanded_ordering(const internal::Ordering& order, int width);

}  // namespace Conformal_geometry_processing
