// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// Converts points of the plane to points of space with z = 0, 3 x n
Points in_space(const Eigen::VectorXcd& z);

/// \ingroup PkgParameterization
/// \brief Applies the similarity to a map such that the sum of the areas of its faces is the area
/// of the surface, the mean of the loop is the origin, and the first vertex of the loop is on the
/// positive real axis.
/// \param z |V|
/// \param loop some vertices, at least one
Eigen::VectorXcd place_in_plane(const Mesh_view& mesh, Eigen::VectorXcd z,
                                const std::vector<int>& loop);

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

/// \ingroup PkgParameterization
/// \brief Moves the images of components in the plane so that their bounding boxes do not overlap,
/// by `pack_in_rows()` with gaps of a hundredth of the largest extent. O(|V| + n log n) for n
/// components
/// \param component of each vertex, numbered from 0 without gaps, as `connected_components()` does
/// \param z u + i v of each vertex, finite
void place_side_by_side(const std::vector<int>& component, Eigen::VectorXcd& z);

}  // namespace Conformal_geometry_processing
