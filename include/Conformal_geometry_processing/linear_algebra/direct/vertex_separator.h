// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/direct/Graph_region.h>

#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// Candidate vertices of a separator, with local indices.
struct Separator_band {
  std::vector<int> vertices, number;  // band to region; region to band, -1 outside
  Terminal_graph graph;

  void add(int v);
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Minimizes a separator: from its vertices, and the ends of edges that join left and right
/// directly, selects a minimum set that separates left and right.
///
/// The other vertices keep their sides. The separator is placed near the larger side.
/// O(edges + edges of the separator * sqrt(vertices of the separator)) at worst.
/// \param[in,out] sides one for each vertex; if they contain no separator, it is chosen among the
/// ends of cut edges
void thin_separator(const internal::Graph_region& region, std::vector<internal::Side>& sides);

}  // namespace Conformal_geometry_processing
