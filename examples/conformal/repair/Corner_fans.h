// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <array>
#include <cstddef>
#include <vector>

namespace conformal {

/// \brief Connected fans of polygon corners around vertices: two corners of neighbours are in the
/// same fan if exactly two faces share the edge between them, in opposite directions.
///
/// If every fan has its own vertex, the faces form an oriented manifold: each corner has two edges,
/// so that a fan is a path or a cycle, and if its two ends share an edge, they have opposite
/// directions there.
class Corner_fans {
 public:
  /// an edge by its vertices, the smaller first
  using Edge = std::array<int, 2>;

  /// \param cuts edges across which corners are not in the same fan, in ascending order
  explicit Corner_fans(const Polygons& polygons, const std::vector<Edge>& cuts = {});

  int size() const { return m_size; }
  int of_corner(std::size_t c) const { return m_fan[c]; }

  /// edges with more than two faces, or with two that do not agree, and cuts
  int size_of_cut_edges() const { return m_cut_edges; }

 private:
  int m_size = 0, m_cut_edges = 0;
  std::vector<int> m_fan;  // of each corner
};

}  // namespace conformal
