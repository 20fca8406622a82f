// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_AGGREGATE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_AGGREGATE_H

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

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/multigrid/aggregate_impl.h>
#endif

#endif
