// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgMesh
/// A mesh without its thinnest faces
struct Well_shaped_faces {
  Mesh_view mesh;    ///< all vertices, and the remaining faces
  double share = 0;  ///< of the remaining faces in the area of the mesh
};

/// The relative height of a face: height over longest edge
struct Face_height {
  double relative, twice_area;
  int face;
  bool operator<(const Face_height& other) const;
};

}  // namespace internal

/// \ingroup PkgMesh
/// \brief Removes the thinnest faces, needles and caps of three degrees or less, but no more than
/// 5 % of the area.
///
/// If the height of a face is less than 5 % of its longest edge, small errors of its corners
/// determine its shape; as long as such faces are few, their distortion says nothing about a map.
/// Faces of area zero are always removed. O(|F| log |F|).
internal::Well_shaped_faces well_shaped_faces(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing
