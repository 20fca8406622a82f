// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/multigrid/strong_connections.h>

#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief A partition of the vertices of a graph into connected groups.
struct Aggregation {
  std::vector<int> aggregate_of;  ///< per vertex; -1 for isolated vertices
  int size = 0;                   ///< number of aggregates
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Groups vertices with their neighborhoods: about nine vertices each on a triangle mesh.
///
/// Vertices with free neighborhoods become centres, in the order of their numbers; each remaining
/// vertex joins the neighborhood with the strongest connection (one exists, because otherwise the
/// vertex would be a centre). Every aggregate has at least two vertices. Linear time.
internal::Aggregation aggregate(const internal::Connection_graph& graph);

}  // namespace Conformal_geometry_processing
