// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/overlaps.h>

#include <Conformal_geometry_processing/mesh/Delaunay_view.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <numeric>

namespace Conformal_geometry_processing::internal {

namespace {

using Triangle = std::array<Eigen::Vector2d, 3>;

double signed_area(const Triangle& t)
{
  const Eigen::Vector2d u = t[1] - t[0], v = t[2] - t[0];
  return (u.x() * v.y() - u.y() * v.x()) / 2;
}

Triangle image(const Mesh_view& mesh, int f, const Points& positions)
{
  Triangle t;
  for (std::size_t c = 0; c < 3; ++c) t[c] = positions.col(mesh.corners(f)[c]).head<2>();
  return t;
}

/// A face of positive area in the plane, and the box around it
struct Flat_face {
  int face;
  Triangle corners;
  double area, left, right, low, high;

  Flat_face(int f, const Triangle& z) : face(f), corners(z), area(signed_area(z))
  {
    const auto x = std::minmax({z[0].x(), z[1].x(), z[2].x()});
    const auto y = std::minmax({z[0].y(), z[1].y(), z[2].y()});
    left = x.first, right = x.second, low = y.first, high = y.second;
  }
};

double common_area(const Flat_face& a, const Flat_face& b)
{
  Plane_polygon part(a.corners.begin(), a.corners.end());
  for (std::size_t c = 0; c < 3 && !part.empty(); ++c)
    part = clipped(part, b.corners[c], b.corners[(c + 1) % 3]);
  return area_of(part);
}

std::vector<Flat_face> by_left_end(const Mesh_view& mesh, const Points& positions)
{
  std::vector<Flat_face> faces;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const Flat_face face(f, image(mesh, f, positions));
    if (face.area > 0) faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end(),
            [](const Flat_face& a, const Flat_face& b) { return a.left < b.left; });
  return faces;
}

// of the smaller face; less is rounding along common edges
const double least_share = 1e-6;

}  // namespace

std::vector<Overlap> overlaps(const Mesh_view& mesh, const Points& positions)
{
  const std::vector<Flat_face> faces = by_left_end(mesh, positions);
  std::vector<Overlap> found;
  for (auto a = faces.begin(); a != faces.end(); ++a)
    for (auto b = a + 1; b != faces.end() && b->left < a->right; ++b) {
      if (b->high <= a->low || a->high <= b->low) continue;
      const double area = common_area(*a, *b);
      if (area > least_share * (std::min)(a->area, b->area))
        found.push_back({(std::min)(a->face, b->face), (std::max)(a->face, b->face), area});
    }
  std::sort(found.begin(), found.end(), [](const Overlap& a, const Overlap& b) {
    return std::array{a.first, a.second} < std::array{b.first, b.second};
  });
  return found;
}

Overlap_summary overlap_summary(const std::vector<Overlap>& pairs, const Mesh_view& mesh,
                                const Points& positions)
{
  std::vector<char> has_one(static_cast<std::size_t>(mesh.size_of_faces()), 0);
  Overlap_summary found;
  for (const auto& [first, second, area] : pairs) {
    has_one[static_cast<std::size_t>(first)] = has_one[static_cast<std::size_t>(second)] = 1;
    found.share += area;
  }
  found.faces = static_cast<int>(std::count(has_one.begin(), has_one.end(), 1));
  double area = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    area += std::abs(signed_area(image(mesh, f, positions)));
  if (area > 0) found.share /= area;
  return found;
}

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
