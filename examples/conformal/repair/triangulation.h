// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/data/Surface_file.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <array>
#include <cstddef>
#include <vector>

namespace conformal {

/// the triangles of all faces of a file, in their order
struct Triangulation {
  Conformal_geometry_processing::Mesh_view::Corners corners;
  std::vector<int> face_in_file;                   ///< of each triangle
  std::vector<std::array<std::size_t, 3>> places;  ///< of its corners among those of the file
  int triangulated = 0;                            ///< number of faces with more than three corners
};

/// \brief Cuts polygons into triangles without new vertices: ear clipping in the plane that fits
/// the polygon best, so that dents are respected; the roundest ear first.
Triangulation triangulate(const Surface_file& file);

/// Likewise for one polygon, given by the places of its corners among those of the file, which may
/// be joined to holes by bridges.
/// \returns places
std::vector<std::array<std::size_t, 3>> triangles_of(const Surface_file& file,
                                                     const std::vector<std::size_t>& places);

}  // namespace conformal
