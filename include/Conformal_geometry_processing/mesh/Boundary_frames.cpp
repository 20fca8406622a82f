// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

Eigen::Vector3d circle_tangent(const Eigen::Vector3d& previous, const Eigen::Vector3d& here,
                               const Eigen::Vector3d& next)
{
  const Eigen::Vector3d in = here - previous, out = next - here;
  if (in.isZero(0) || out.isZero(0)) return in + out;
  // Each unit edge weighted by the length of the other: the shorter one is nearer to the tangent.
  return stable_norm(out) * stable_normalized(in) + stable_norm(in) * stable_normalized(out);
}

internal::Boundary_frame boundary_frame(const Eigen::Vector3d& tangent,
                                        const Eigen::Vector3d& normal)
{
  const Eigen::Vector3d T = stable_normalized(tangent);
  const Eigen::Vector3d N = stable_normalized(normal - normal.dot(T) * T);
  internal::Boundary_frame frame;
  frame << T, N, T.cross(N);
  return frame;
}

internal::Boundary_frames frames_along(const Surface_ref& surface,
                                       std::vector<std::vector<int>> loops)
{
  const Points normals = vertex_normals(surface, internal::Normal_weight::angle);
  internal::Boundary_frames b;
  b.loops = std::move(loops);
  for (const std::vector<int>& loop : b.loops) {
    const std::size_t n = loop.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Eigen::Vector3d along =
          circle_tangent(surface.position(loop[(k + n - 1) % n]), surface.position(loop[k]),
                         surface.position(loop[(k + 1) % n]));
      b.vertices.push_back(loop[k]);
      b.frames.push_back(boundary_frame(along, normals.col(loop[k])));
    }
  }
  return b;
}

internal::Boundary_frames boundary_frames(const Surface_ref& surface)
{
  return frames_along(surface, boundary_loops(surface));
}

}  // namespace Conformal_geometry_processing
