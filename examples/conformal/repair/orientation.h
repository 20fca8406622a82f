// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace conformal {

/// which faces of a file to turn around so that neighbours agree
struct Orientation {
  bool is_orientable = true;
  std::vector<char> is_turned;  ///< per face of the file: the fewer ones of each component
};

/// \param face_in_file the face of the file that contains a triangle
/// \param size number of faces in the file
Orientation find_orientation(const Conformal_geometry_processing::Mesh_view& mesh,
                             const std::vector<int>& face_in_file, std::size_t size);

/// Reverses the corners of faces, with all that belongs to their corners.
void turn_faces(Surface_file& file, const std::vector<char>& is_turned);

}  // namespace conformal
