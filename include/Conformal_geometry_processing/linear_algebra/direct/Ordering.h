// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>

#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
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

}  // namespace Conformal_geometry_processing
