// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_MEND_FLAT_FACES_H
#define CONFORMAL_MEND_FLAT_FACES_H

#include "io/Surface_file.h"

#include <array>
#include <utility>
#include <vector>

namespace conformal {

/// what was done to get rid of faces of area zero
struct Mended_faces {
  int flipped_edges = 0;
  int cut_polygons = 0;  ///< of which only triangles are left
  /// corners of what was removed at the boundary, or of a component that has no area at all
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
/// - Where no flip helps (the other diagonal exists, or would be no shorter), the edge is collapsed
///   that changes areas the least, if that makes no edge with more than two faces and turns no face
///   over.
/// - Two corners nearer than 1e-12 of the longest edge become one, whatever that makes of the rest.
/// - A triangle with a corner at the boundary, or where the surface must be cut, is removed.
///
/// Each step leaves fewer faces of area zero or shorter edges, so that it ends. What cannot be
/// mended is left as it is.
///
/// \pre neighbours agree in their orientation where they can; no face is there twice
Mended_faces mend_flat_faces(Surface_file& file);

}  // namespace conformal

#endif
