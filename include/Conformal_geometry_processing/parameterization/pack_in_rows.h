// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief Places rectangles side by side in rows, the highest ones first. The length of a row is
/// about the side of a square of the same total area. Rectangles do not overlap, and lie above and
/// to the right of the origin.
///
/// A rectangle that would exceed its row by more than half begins the next row.
///
/// \param sizes width and height of each, 2 x n
/// \param gap between them
/// \returns the lower left corner of each, 2 x n. O(n log n)
Eigen::Matrix2Xd pack_in_rows(const Eigen::Matrix2Xd& sizes, double gap);

}  // namespace Conformal_geometry_processing
