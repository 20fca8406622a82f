// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Surface_input.h"

#include <vector>

namespace conformal {

/// What became of the faces of a file whose edges were flipped
struct Delaunay_faces {
  int flips = 0;
  std::vector<int> face_before;  ///< of each face now: that of the file in whose place it is
  std::vector<int> changed;      ///< the faces now that have other corners than that, ascending
};

/// \brief Flips edges of a surface and its file until it is Delaunay, see `CGP::make_delaunay()`;
/// polygons become triangles. Without flips nothing changes.
///
/// Vertices keep their properties, faces those of the face in whose place they are. Values at
/// corners are left out, with a note.
/// \param mollification of the lengths by which edges are flipped; 0: none
Delaunay_faces make_delaunay(Surface_input& input, double mollification);

}  // namespace conformal
