// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing {

Boundary_condition Boundary_condition::tangents(Points targets)
{
  return directions({1, 0, 0}, std::move(targets));
}

Boundary_condition Boundary_condition::binormals(Points targets)
{
  return directions({0, 0, 1}, std::move(targets));
}

Boundary_condition Boundary_condition::directions(const Eigen::Vector3d& direction, Points targets)
{
  return {Kind::directions, direction, std::move(targets), Points(3, 0)};
}

Boundary_condition Boundary_condition::positions(Points targets, Points normals, double weight)
{
  return {Kind::positions, {1, 0, 0}, std::move(targets), std::move(normals), weight};
}

internal::Boundary_frames frames_of(const Surface_ref& surface, const Boundary_condition& condition)
{
  std::vector<std::vector<int>> loops = boundary_loops(surface);
  loops.insert(loops.end(), condition.curves.begin(), condition.curves.end());
  return frames_along(surface, std::move(loops));
}

namespace internal {

inline void require_curves(const Surface_ref& surface, const std::vector<std::vector<int>>& curves,
                           const std::string& function)
{
  std::vector<char> is_taken = boundary_vertices(surface);
  for (const std::vector<int>& curve : curves) {
    if (curve.size() < 3)
      throw Precondition_error(function, "a curve of " + std::to_string(curve.size()) +
                                             " vertices; at least three are needed");
    for (const int v : curve) {
      const bool exists = v >= 0 && v < surface.size_of_vertices();
      if (!exists || is_taken[static_cast<std::size_t>(v)])
        throw Precondition_error(function, name_of_vertex(v) +
                                               " of a curve is not inside the "
                                               "surface, or is on curves twice");
      is_taken[static_cast<std::size_t>(v)] = 1;
    }
  }
}

}  // namespace internal

void require_condition(const Surface_ref& surface, const Boundary_condition& condition,
                       const std::string& function)
{
  using Kind = Boundary_condition::Kind;
  if (condition.kind == Kind::free) return;
  internal::require_curves(surface, condition.curves, function);
  const internal::Boundary_frames boundary = frames_of(surface, condition);
  const std::vector<int>& vertices = boundary.vertices;
  const auto count = static_cast<Eigen::Index>(vertices.size());
  if (boundary_loops(surface).empty())
    throw Precondition_error(function, "the surface is closed; no boundary can be prescribed");
  internal::refuse_if_any(
      static_cast<int>(count),
      [&](int k) { return !(boundary.frames[static_cast<std::size_t>(k)].determinant() > 0.5); },
      [&](int k) { return internal::name_of_vertex(vertices[static_cast<std::size_t>(k)]); },
      function, "boundary #vertex without tangent or normal", "the boundary must not fold back");
  const std::string whose =
      condition.curves.empty() ? "boundary vertex" : "vertex of the boundary and the curves";
  const bool is_directions = condition.kind == Kind::directions;
  const auto require_size = [&](const Points& p, const std::string& what, bool is_optional) {
    if (p.cols() != count && !(is_optional && p.cols() == 0))
      throw Precondition_error(function, std::to_string(p.cols()) + " " + what + ", one per " +
                                             whose + " is needed: " + std::to_string(count));
  };
  const auto require_good = [&](const Points& p, const std::string& what, bool is_direction) {
    internal::refuse_if_any(
        static_cast<int>(p.cols()),
        [&](int k) {
          return !p.col(k).allFinite() || (is_direction && !(stable_norm(p.col(k)) > 0));
        },
        [&](int k) { return internal::name_of_vertex(vertices[static_cast<std::size_t>(k)]); },
        function, what,
        is_direction ? "finite vectors that are not zero are needed"
                     : "finite coordinates are needed");
  };
  require_size(condition.targets, is_directions ? "directions" : "positions", is_directions);
  require_good(condition.targets,
               is_directions ? "#direction zero or not finite" : "#position not finite",
               is_directions);
  if (!is_directions) {
    if (!(condition.weight > 0))
      throw Precondition_error(function, "the weight of positions must be positive");
    require_size(condition.normals, "normals", false);
    require_good(condition.normals, "#normal zero or not finite", true);
    return;
  }
  const Eigen::Vector3d d = condition.direction;
  if (!d.allFinite() || !(std::hypot(d.x(), d.z()) > 1e-3 * std::abs(d.y())))
    throw Precondition_error(function,
                             "only tangents, binormals and directions between them and the normal "
                             "can be prescribed; that of the normal is not elliptic");
}

}  // namespace Conformal_geometry_processing
