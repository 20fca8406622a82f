// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/charts.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <numeric>

namespace Conformal_geometry_processing::internal {
namespace {

std::size_t at(int i)
{
  return static_cast<std::size_t>(i);
}

/// Visits faces across edges, the nearest ones to the first ones first.
/// \param visit whether to go on from a face that was reached from the other, or -1 at first
template <class Visit>
void spread(const Mesh_view& mesh, std::deque<int> faces, Visit visit)
{
  for (; !faces.empty(); faces.pop_front())
    for (int c = 0; c < 3; ++c) {
      const int t = mesh.twin(3 * faces.front() + c);
      if (t >= 0 && visit(Mesh_view::face(t), faces.front())) faces.push_back(Mesh_view::face(t));
    }
}

/// How many faces it takes from the boundary to each one; 0 if there is none
std::vector<int> depths(const Mesh_view& mesh)
{
  std::vector<int> depth(at(mesh.size_of_faces()), 0);
  std::deque<int> border;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    if ((std::min)({mesh.twin(3 * f), mesh.twin(3 * f + 1), mesh.twin(3 * f + 2)}) < 0) {
      depth[at(f)] = 1;
      border.push_back(f);
    }
  spread(mesh, std::move(border), [&](int f, int from) {
    if (depth[at(f)] > 0) return false;
    depth[at(f)] = depth[at(from)] + 1;
    return true;
  });
  return depth;
}

/// the faces, the deepest first
std::vector<int> by_depth(const Mesh_view& mesh)
{
  const std::vector<int> depth = depths(mesh);
  std::vector<int> faces(depth.size());
  std::iota(faces.begin(), faces.end(), 0);
  std::stable_sort(faces.begin(), faces.end(),
                   [&](int f, int g) { return depth[at(f)] > depth[at(g)]; });
  return faces;
}

}  // namespace

std::vector<int> charts_without(const std::vector<Overlap>& overlaps, const Mesh_view& mesh)
{
  std::vector<std::vector<int>> rivals(at(mesh.size_of_faces()));
  for (const Overlap& overlap : overlaps) {
    rivals[at(overlap.first)].push_back(overlap.second);
    rivals[at(overlap.second)].push_back(overlap.first);
  }
  std::vector<int> chart(rivals.size(), -1);
  int count = 0;
  const auto join = [&](int f, int = -1) {
    const bool is_free =
        chart[at(f)] < 0 && std::none_of(rivals[at(f)].begin(), rivals[at(f)].end(),
                                         [&](int g) { return chart[at(g)] == count; });
    if (is_free) chart[at(f)] = count;
    return is_free;
  };
  for (const int f : by_depth(mesh)) {
    if (!join(f)) continue;
    spread(mesh, {f}, join);
    ++count;
  }
  return chart;
}

}  // namespace Conformal_geometry_processing::internal
