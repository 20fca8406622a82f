// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODES_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_SUPERNODES_H

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// the widest supernode: a panel of so many quaternionic columns stays in the second-level cache
constexpr int max_supernode_width = 64;

namespace internal {

/// Columns that have the same rows below: j and j + 1 if j + 1 is the parent of j, its only child,
/// and has one row less. Returns the first column of each, and the number of columns at the end.
std::vector<int> fundamental_supernodes(const std::vector<int>& parent,
                                        const std::vector<int>& count);

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief groups the columns of a Cholesky factor into supernodes, which are stored as dense
/// panels; the first column of each, and the number of columns at the end.
///
/// Fundamental supernodes are merged with the parent that follows them as long as the zeros this
/// stores are worth it (Ashcraft and Grimes 1989), then cut to `max_supernode_width`.
/// \param parent the elimination tree, numbered in postorder \param count `column_counts()`
std::vector<int> relaxed_supernodes(const std::vector<int>& parent, const std::vector<int>& count);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/supernodes_impl.h>
#endif

#endif
