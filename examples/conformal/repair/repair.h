// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <array>
#include <string>
#include <vector>

namespace conformal {

/// \brief Record of the operations that made the faces of a file an oriented manifold of faces with
/// positive areas, and of the new numbers of vertices and faces.
struct Repair {
  int merged_points = 0;    ///< vertices that lay exactly upon another
  int removed_faces = 0;    ///< fewer than three different corners were left, or it was there twice
  int shortened_faces = 0;  ///< polygons that had a corner twice in a row, and three others
  int bridged_faces = 0;    ///< polygons cut into triangles, since bridges join them to holes
  int turned_faces = 0;     ///< to agree with their neighbours
  int cut_edges = 0;        ///< where more than two faces meet, or neighbours cannot agree
  int added_vertices = 0;   ///< copies, for fans of faces that only touch
  int removed_vertices = 0;  ///< without a face

  /// done to triangles of area zero whose corners are different points, see `mend_flat_faces()`
  int flipped_edges = 0, collapsed_edges = 0;
  int removed_flat_faces = 0;  ///< at the boundary, or of components without an area
  int cut_polygons = 0;        ///< that had such triangles for a part or a neighbour
  double longest_collapsed_edge = 0;

  std::vector<int> vertex_in_file, face_in_file;  ///< of what there is now, where it was
  std::vector<int> new_vertex, new_face;          ///< of old elements: the first copy, or -1

  /// the points and faces as they were, if anything has changed
  Surface_file before;
  /// the corners of the flat triangles that were removed, by the numbers they had
  std::vector<std::array<int, 3>> removed_triangles;

  bool has_changed_anything() const;
  std::vector<std::string> notes() const;  ///< a line for each thing done
};

/// \brief Merges coincident points, removes degenerate and repeated faces, orients the rest, mends
/// faces of area zero, separates the surface where it is not a manifold, and removes vertices
/// without a face. If there is nothing to do, the file is bitwise unchanged.
///
/// Elements keep their order, their properties and the values at their corners; copies of vertices
/// come last, and parts of a face replace it. Points are not moved. A face of area zero that cannot
/// be mended stays. Elements that are neither vertices nor faces are removed, with a note, if
/// vertices are renumbered.
/// \param file may have been read with `Bad_faces::kept`
/// \throws Failure if no face would remain
Repair repair(Surface_file& file);

}  // namespace conformal
