// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/overlaps.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief Divides a surface into charts such that no two faces of a chart overlap in the plane.
///
/// Each chart grows across edges, from the face deepest inside that has none yet, as long as it
/// does not meet itself. O(|F| log |F| + overlaps)
/// \returns the chart of each face, numbered from 0; one chart of each component without overlaps
std::vector<int> charts_without(const std::vector<Overlap>& overlaps, const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing::internal
