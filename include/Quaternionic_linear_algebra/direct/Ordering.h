// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief An elimination order: entry k is the number of the row that is eliminated as k-th.
///
/// Orders the n rows of a `Sparse_pattern` for any scalar type, so that the real and the
/// quaternionic matrix of a mesh can share it.
using Ordering = std::vector<int>;

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// Permutation from old to new numbers; empty if `order` is not a permutation of 0 ... n - 1
std::vector<int> inverse_permutation(const internal::Ordering& order);

/// \ingroup PkgLinearAlgebra
/// Computes an approximate minimum degree ordering (Amestoy, Davis and Duff 1996) with Eigen
internal::Ordering amd_ordering(const Sparse_pattern& pattern);

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

namespace internal {

// Adjacency lists in compressed form.
struct Neighbour_lists {
  std::vector<int> offsets, neighbours;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Orders the vertices by their distance along edges from a peripheral vertex.
///
/// For distribution, not for factorization: consecutive vertices form slices of the mesh with short
/// boundaries, so processes that own a range each communicate with few others. Connected components
/// are ordered one after the other. O(|V| + |E|).
internal::Ordering breadth_first_ordering(const Sparse_pattern& pattern);

}  // namespace Conformal_geometry_processing
