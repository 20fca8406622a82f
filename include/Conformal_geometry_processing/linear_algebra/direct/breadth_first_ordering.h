// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>

#include <vector>

namespace Conformal_geometry_processing {

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
