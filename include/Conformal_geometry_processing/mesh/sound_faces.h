// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_SOUND_FACES_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_SOUND_FACES_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <algorithm>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// the part of a mesh whose shape can be compared
struct Sound_faces {
  Mesh_view mesh;    ///< all vertices, and the faces that are not thin
  double share = 0;  ///< of the area of the mesh
};

/// \ingroup PkgMesh
/// \brief leaves out the faces whose height is less than 5 % of their longest edge: needles and
/// caps of three degrees or less.
///
/// The shape of such a face is decided by errors of its corners that are small beside its edges, so
/// that it tells nothing of a map. O(|F|).
inline Sound_faces sound_faces(const Mesh_view& mesh)
{
  const double least_height = 0.05;
  Mesh_view::Corners sound;
  double all = 0, share = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double twice_area = mesh.double_area_vector(f).norm();
    double longest = 0;  // squared
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      longest = std::max(longest, mesh.vector(h).squaredNorm());
    all += twice_area;
    if (!(twice_area > least_height * longest)) continue;
    sound.push_back(mesh.corners(f));
    share += twice_area;
  }
  return {{mesh.positions(), std::move(sound)}, share > 0 ? share / all : 0};
}

}  // namespace Conformal_geometry_processing

#endif
