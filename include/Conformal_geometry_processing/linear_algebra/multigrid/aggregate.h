// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_AGGREGATE_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_MULTIGRID_AGGREGATE_H

#include <Conformal_geometry_processing/linear_algebra/multigrid/strong_connections.h>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief a partition of the vertices of a graph into connected groups.
struct Aggregation {
  std::vector<int> aggregate_of;  ///< per vertex; -1 where it has no connection at all
  int size = 0;                   ///< number of aggregates
};

/// \ingroup PkgLinearAlgebra
/// \brief groups every vertex with its neighborhood: about nine vertices each on a triangle mesh.
///
/// Vertices with free neighborhoods become centres, in the order of their numbers; a vertex that is
/// left over joins the neighborhood to which its connection is strongest (there is one, for else it
/// would have become a centre). Every aggregate has at least two vertices. Linear time.
Aggregation aggregate(const Connection_graph& graph);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/multigrid/aggregate_impl.h>
#endif

#endif
