// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_CORNER_FANS_H
#define CONFORMAL_CORNER_FANS_H

#include "io/Surface_file.h"

#include <cstddef>
#include <vector>

namespace conformal {

/// \brief The corners of polygons that hang together around a vertex: two corners of neighbours are
/// in one fan if exactly two faces share the edge between them, and pass it in opposite directions.
///
/// If every fan has a vertex of its own, the faces are an oriented manifold: each corner has two
/// edges, so that a fan is a path or a cycle, and its two ends pass an edge that they may still
/// share in opposite directions.
class Corner_fans {
 public:
  explicit Corner_fans(const Polygons& polygons);

  int size() const { return m_size; }
  int of_corner(std::size_t c) const { return m_fan[c]; }

  /// edges with more than two faces, or with two that do not agree
  int size_of_cut_edges() const { return m_cut_edges; }

 private:
  int m_size = 0, m_cut_edges = 0;
  std::vector<int> m_fan;  // of each corner
};

}  // namespace conformal

#endif
