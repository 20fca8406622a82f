// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace Conformal_geometry_processing::internal {

/// two faces whose images in the plane have an area in common
struct Overlap {
  int first, second;  ///< first < second
  double area;        ///< what they have in common
};

/// \brief The overlaps of a map to the plane, in ascending order: pairs of faces that have more in
/// common than a millionth of the smaller one.
///
/// Flipped faces are left out: their neighbours cover the same place, and `flipped_faces()` counts
/// them. Sorts the faces along x, and compares those above each other: O(|F|^1.5) for faces of like
/// sizes.
/// \param positions in the plane, finite, 3 x |V|; z is left out
std::vector<Overlap> overlaps(const Mesh_view& mesh, const Points& positions);

/// how much of a map to the plane covers what another part of it covers
struct Overlap_summary {
  int faces = 0;     ///< that overlap another one
  double share = 0;  ///< common area of all pairs by the area of the image
};

/// \param pairs from `overlaps()`
Overlap_summary overlap_summary(const std::vector<Overlap>& pairs, const Mesh_view& mesh,
                                const Points& positions);

/// \brief Divides a surface into charts such that no two faces of a chart overlap in the plane.
///
/// Each chart grows across edges, from the face deepest inside that has none yet, as long as it
/// does not meet itself. O(|F| log |F| + overlaps)
/// \returns the chart of each face, numbered from 0; one chart of each component without overlaps
std::vector<int> charts_without(const std::vector<Overlap>& overlaps, const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing::internal
