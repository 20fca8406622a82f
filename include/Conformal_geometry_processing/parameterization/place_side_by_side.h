// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief Moves the images of components in the plane so that their bounding boxes do not overlap,
/// by `pack_in_rows()` with gaps of a hundredth of the largest extent. O(|V| + n log n) for n
/// components
/// \param component of each vertex, numbered from 0 without gaps, as `connected_components()` does
/// \param z u + i v of each vertex, finite
void place_side_by_side(const std::vector<int>& component, Eigen::VectorXcd& z);

}  // namespace Conformal_geometry_processing
