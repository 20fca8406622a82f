// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace conformal {

/// the shapes of the triangles and edges of any mesh
struct Shape {
  double area = 0;
  double diagonal = 0;          ///< of the bounding box
  double min_angle = 0;         ///< in degrees
  double edge_ratio = 0;        ///< longest to shortest edge
  double negative_weights = 0;  ///< share of edges with a negative cotan weight
};

/// \pre the mesh has a face
Shape shape(const Conformal_geometry_processing::Mesh_view& mesh);

}  // namespace conformal
