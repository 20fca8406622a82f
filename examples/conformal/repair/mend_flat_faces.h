// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <array>
#include <utility>
#include <vector>

namespace conformal {

/// Operations that have removed faces of area zero
struct Mended_faces {
  int flipped_edges = 0;
  int cut_polygons = 0;  ///< of which only triangles are left
  /// Corners of triangles removed at the boundary, or with a component that has no area
  std::vector<std::array<int, 3>> removed;
  std::vector<std::pair<int, int>> collapsed;  ///< this vertex into that one, in their order
  double longest_collapsed = 0;                ///< length of the longest such edge

  std::vector<int> face_in_file;  ///< of each face, which it was before
};

/// \brief Removes triangles without area (`CGP::relative_area_tolerance`) whose corners are
/// different points; no point moves.
///
/// In this order:
/// - The edge opposite the largest angle is flipped, so that the third corner splits the neighbour;
///   at the boundary, and where more than two faces meet, the triangle is removed.
/// - If a flip is not possible (the other diagonal exists, or is not shorter), the edge is
///   collapsed that changes areas the least, provided that no edge gets more than two faces and no
///   face is turned over.
/// - Two corners nearer than 1e-12 of the longest edge are merged, regardless of the other faces.
/// - A triangle with a corner at the boundary, or where the surface must be cut, is removed.
///
/// Each step reduces the number of faces of area zero or shortens edges, so that it terminates.
/// Faces that cannot be mended are unchanged.
///
/// \pre neighbours agree in their orientation where they can; no face is there twice
Mended_faces mend_flat_faces(Surface_file& file);

}  // namespace conformal
