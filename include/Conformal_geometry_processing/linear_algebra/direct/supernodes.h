// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODES_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODES_H

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// Maximal width of a supernode: a panel of 64 quaternionic columns fits in the second-level cache
constexpr int max_supernode_width = 64;

namespace internal {

/// Groups columns with the same rows below: j and j + 1 if j + 1 is the parent of j, its only
/// child, and has one row less. Returns the first column of each group, and the number of columns
/// at the end.
std::vector<int> fundamental_supernodes(const std::vector<int>& parent,
                                        const std::vector<int>& count);

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Groups the columns of a Cholesky factor into supernodes, which are stored as dense
/// panels; returns the first column of each, and the number of columns at the end.
///
/// Merges fundamental supernodes with the parent that follows them as long as the additional zeros
/// pay off (Ashcraft and Grimes 1989), then divides them to `max_supernode_width`.
/// \param parent the elimination tree, numbered in postorder \param count `column_counts()`
std::vector<int> relaxed_supernodes(const std::vector<int>& parent, const std::vector<int>& count);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/supernodes_impl.h>
#endif

#endif
