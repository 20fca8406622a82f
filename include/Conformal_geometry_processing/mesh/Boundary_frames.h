// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_BOUNDARY_FRAMES_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_BOUNDARY_FRAMES_H

#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief the right-handed orthonormal frame (T, N, B) of a surface at a vertex of its boundary, in
/// columns: T along the boundary with the surface on its left, N the normal, B = T x N pointing out
/// of the surface.
using Boundary_frame = Eigen::Matrix3d;

/// \ingroup PkgMesh
/// \brief the boundary of a surface, vertex after vertex, with a frame at each.
///
/// T is the direction from the vertex before to the one after, the mean of the two edges weighted
/// by their lengths: second order, where the outgoing edge alone would be first order and spoil the
/// symmetry of the Dirac operator. N is the angle-weighted normal of the vertex, made orthogonal to
/// T. Where an edge is so folded that T or N vanish, the frame holds zeros.
struct Boundary_frames {
  std::vector<std::vector<int>> loops;  ///< as `boundary_loops()` returns them
  std::vector<int> vertices;            ///< all of them, loop after loop
  std::vector<Boundary_frame> frames;   ///< one for each of `vertices`

  Eigen::Vector3d tangent(std::size_t k) const { return frames[k].col(0); }
  Eigen::Vector3d normal(std::size_t k) const { return frames[k].col(1); }
  Eigen::Vector3d binormal(std::size_t k) const { return frames[k].col(2); }
};

/// \ingroup PkgMesh
/// the frame of a tangent and a normal, which need be neither unit vectors nor orthogonal
inline Boundary_frame boundary_frame(const Eigen::Vector3d& tangent, const Eigen::Vector3d& normal)
{
  const Eigen::Vector3d T = stable_normalized(tangent);
  const Eigen::Vector3d N = stable_normalized(normal - normal.dot(T) * T);
  Boundary_frame frame;
  frame << T, N, T.cross(N);
  return frame;
}

/// \ingroup PkgMesh
/// \brief the frames of boundary loops of given points and normals, both 3 x |V|
inline Boundary_frames boundary_frames(const Points& points, const Points& normals,
                                       std::vector<std::vector<int>> loops)
{
  Boundary_frames b;
  b.loops = std::move(loops);
  for (const std::vector<int>& loop : b.loops) {
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Eigen::Vector3d along =
          points.col(loop[(k + 1) % n]) - points.col(loop[(k + n - 1) % n]);
      b.vertices.push_back(loop[k]);
      b.frames.push_back(boundary_frame(along, normals.col(loop[k])));
    }
  }
  return b;
}

/// \ingroup PkgMesh
/// the frames of all boundary vertices; O(|V| + |F|)
/// \pre `require_surface(mesh)` holds
inline Boundary_frames boundary_frames(const Mesh_view& mesh)
{
  return boundary_frames(mesh.positions(), vertex_normals(mesh, Normal_weight::angle),
                         boundary_loops(mesh));
}

}  // namespace Conformal_geometry_processing

#endif
