// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>

#include <Conformal_geometry_processing/mesh/normals.h>

#include <Eigen/Geometry>

#include <utility>

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

std::vector<std::vector<int>> internal::closed_curves(const Mesh_view& mesh,
                                                      const std::vector<char>& is_marked,
                                                      const std::string& function,
                                                      const std::function<std::string(int)>& name)
{
  const auto at = [](int v) { return static_cast<std::size_t>(v); };
  std::vector<std::vector<int>> neighbors(is_marked.size());
  for (int e = 0; e < mesh.size_of_edges(); ++e) {
    const auto [i, j] = mesh.ends(e);
    if (!is_marked[at(i)] || !is_marked[at(j)]) continue;
    neighbors[at(i)].push_back(j);
    neighbors[at(j)].push_back(i);
  }
  refuse_if_any(
      static_cast<int>(is_marked.size()),
      [&](int v) { return is_marked[at(v)] && neighbors[at(v)].size() != 2; }, name, function,
      "#vertex on no closed curve", "two neighbours on it are needed, and no more");
  std::vector<std::vector<int>> curves;
  std::vector<char> is_visited(is_marked.size(), 0);
  for (int first = 0; first < mesh.size_of_vertices(); ++first) {
    if (!is_marked[at(first)] || is_visited[at(first)]) continue;
    curves.emplace_back();
    for (int last = -1, here = first; !is_visited[at(here)];) {
      curves.back().push_back(here);
      is_visited[at(here)] = 1;
      const std::vector<int>& next = neighbors[at(here)];
      const int before = last;
      last = here;
      here = next[0] == before ? next[1] : next[0];
    }
  }
  return curves;
}

}  // namespace Conformal_geometry_processing
