// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_WELL_SHAPED_FACES_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_WELL_SHAPED_FACES_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// the part of a mesh whose shape can be compared
struct Well_shaped_faces {
  Mesh_view mesh;    ///< all vertices, and the faces that are not left out
  double share = 0;  ///< of the area of the mesh
};

namespace internal {

/// a face by its thinness: height over longest edge
struct Face_height {
  double relative, twice_area;
  int face;
  bool operator<(const Face_height& other) const;
};

}  // namespace internal

/// \ingroup PkgMesh
/// \brief leaves out the thinnest faces, needles and caps of three degrees or less, but of no more
/// than 5 % of the area.
///
/// The shape of a face whose height is less than 5 % of its longest edge is decided by errors of
/// its corners that are small beside its edges: as long as such faces are few, they tell nothing of
/// a map. Faces of area zero are always left out. O(|F| log |F|).
Well_shaped_faces well_shaped_faces(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/well_shaped_faces_impl.h>
#endif

#endif
