// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_REPAIR_H
#define CONFORMAL_REPAIR_H

#include "io/Surface_file.h"

#include <string>
#include <vector>

namespace conformal {

/// \brief What was done to make the faces of a file an oriented manifold, and which vertex and face
/// became which.
struct Repair {
  int merged_points = 0;   ///< vertices that lay exactly upon another
  int removed_faces = 0;   ///< fewer than three different corners were left, or it was there twice
  int turned_faces = 0;    ///< to agree with their neighbours
  int cut_edges = 0;       ///< where more than two faces meet, or neighbours cannot agree
  int added_vertices = 0;  ///< copies, for fans of faces that only touch
  int removed_vertices = 0;  ///< without a face

  std::vector<int> vertex_in_file, face_in_file;  ///< of what there is now, where it was
  std::vector<int> new_vertex, new_face;  ///< of what was, where it is (the first copy), or -1

  bool has_changed_anything() const;
  std::vector<std::string> notes() const;  ///< a line for each thing done
};

/// \brief Merges coincident points, removes degenerate and repeated faces, orients the rest,
/// separates the surface where it is no manifold, and removes vertices without a face.
///
/// What is kept keeps its order, its properties and the values at its corners; copies of vertices
/// come last. Faces of area zero whose corners are different points stay: without them, or their
/// neighbours changed, the surface would have a slit. Elements that are neither vertices nor faces
/// are left out, with a note, if vertices have changed their numbers.
Repair repair(Surface_file& file);

}  // namespace conformal

#endif
