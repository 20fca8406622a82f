// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_VERTEX_SEPARATOR_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_VERTEX_SEPARATOR_H

#include <Conformal_geometry_processing/linear_algebra/direct/Graph_region.h>

#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// The vertices among which a separator is chosen, with numbers of their own.
struct Separator_band {
  std::vector<int> vertices, number;  // band to region; region to band, -1 outside
  Terminal_graph graph;

  void add(int v);
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief makes a separator as small as can be: of its vertices, and of the ends of edges that join
/// left to right past it, keeps the fewest without which no path leads from left to right.
///
/// Vertices of the other sides stay there. The separator leans to the greater side.
/// O(edges + edges of the separator * sqrt(vertices of the separator)) at worst.
/// \param[in,out] sides one for each vertex; without a separator it is found between the ends of
/// the edges that are cut
void thin_separator(const Graph_region& region, std::vector<Side>& sides);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/linear_algebra/direct/vertex_separator_impl.h>
#endif

#endif
