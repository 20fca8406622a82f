// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "cut_open.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <vector>

namespace conformal {

/// the image of all components; those without one are a point
struct Flat_components {
  CGP::Points positions;        ///< 3 x |V|
  std::vector<char> has_image;  ///< of each vertex
};

/// Moves the images of components in the plane side by side.
void place_apart(const CGP::Mesh_view& mesh, CGP::Points& positions);

/// \brief Cuts the image of a surface where it overlaps, into charts that do not, side by side; see
/// `charts_without()`. Polygons of the file stay whole.
/// \returns how many charts there are, 0 where nothing overlaps
int cut_overlaps(Cut_surface& surface, Flat_components& flat);

}  // namespace conformal
