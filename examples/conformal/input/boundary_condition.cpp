// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "boundary_condition.h"

#include "Closed_curve.h"
#include "Expression.h"
#include "boundary_curves.h"
#include "rho.h"
#include "same_faces.h"

#include "conformal/process/Failure.h"

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <cmath>
#include <utility>
#include <vector>

namespace conformal {
namespace {

using CGP::Boundary_condition;

Eigen::Index count(const CGP::internal::Boundary_frames& frames)
{
  return static_cast<Eigen::Index>(frames.vertices.size());
}

/// one axis of each of the frames
CGP::Points axes(const CGP::internal::Boundary_frames& frames, Eigen::Index axis)
{
  CGP::Points all(3, count(frames));
  for (Eigen::Index k = 0; k < all.cols(); ++k)
    all.col(k) = frames.frames[static_cast<std::size_t>(k)].col(axis);
  return all;
}

/// the surface of a file that has the same faces
CGP::Mesh_view target_surface(const Surface_input& input, const std::string& path)
{
  return {positions_in(input, read_file_like(input, path)), input.mesh.corners()};
}

/// the closed curves inside the surface whose positions are prescribed, too
std::vector<std::vector<int>> curves_inside(const Surface_input& input,
                                            const Prescription_options& options)
{
  const Eigen::VectorXd numbers = vertex_numbers(
      input, "--curves-expression", options.curves_expression, options.curves_property);
  if (numbers.size() == 0) return {};
  std::vector<char> is_marked(static_cast<std::size_t>(numbers.size()));
  for (std::size_t v = 0; v < is_marked.size(); ++v)
    is_marked[v] = numbers[static_cast<Eigen::Index>(v)] > 0;
  for (const int v : CGP::boundary_frames(input.mesh).vertices)
    is_marked[static_cast<std::size_t>(v)] = 0;
  auto curves = CGP::internal::closed_curves(input.mesh, is_marked, "conformal boundary",
                                             [&](int v) { return name_of_vertex(input, v); });
  if (curves.empty())
    throw unsuitable(input.file.path,
                     "no vertex inside is on a curve, wanted some where it is positive");
  return curves;
}

Boundary_condition positions_of(const CGP::Mesh_view& target, std::vector<std::vector<int>> curves,
                                double weight)
{
  Boundary_condition condition = Boundary_condition::positions({}, {}, weight);
  condition.curves = std::move(curves);
  const auto frames = CGP::frames_of(target, condition);
  condition.normals = axes(frames, 1);
  condition.targets = target.positions()(Eigen::indexing::all, frames.vertices);
  return condition;
}

/// The angles in radians that a formula of degrees gives at the boundary.
Eigen::VectorXd angles(const Surface_input& input, const std::string& text,
                       const std::string& option)
{
  Expression degrees(text, option, {"s", "loop"});
  const User_frame frame(input.mesh);
  const auto frames = CGP::boundary_frames(input.mesh);
  Eigen::VectorXd all(count(frames));
  Eigen::Index k = 0;
  for (std::size_t loop = 0; loop < frames.loops.size(); ++loop) {
    const Closed_curve curve(input.mesh, frames.loops[loop]);
    for (const double s : curve.shares()) {
      const auto i = static_cast<std::size_t>(k);
      const int v = frames.vertices[i];
      const double angle =
          degrees(frame(input.mesh.position(v)), frames.normal(i), {s, static_cast<double>(loop)});
      if (!std::isfinite(angle))
        throw unsuitable(input.file.path,
                         "the angle of " + option + " is not a finite number at " +
                             name_of_vertex(input, v) +
                             ", wanted finite values along the boundary; try: another formula");
      all[k++] = angle * std::acos(-1.) / 180;
    }
  }
  return all;
}

/// first axis, turned by angles towards the second one
CGP::Points turned(const CGP::Points& first, const CGP::Points& second,
                   const Eigen::VectorXd& angles)
{
  return first * angles.array().cos().matrix().asDiagonal() +
         second * angles.array().sin().matrix().asDiagonal();
}

void require_directions(const Surface_input& input, const Boundary_condition& condition)
{
  const std::vector<int> vertices = CGP::boundary_frames(input.mesh).vertices;
  for (Eigen::Index k = 0; k < condition.targets.cols(); ++k)
    if (condition.kind == Boundary_condition::Kind::directions &&
        !(condition.targets.col(k).stableNorm() > 0))
      throw unsuitable(input.file.path,
                       "no direction is prescribed at " +
                           name_of_vertex(input, vertices[static_cast<std::size_t>(k)]) +
                           ", where the boundary is folded onto itself; try: to unfold it");
}

Boundary_condition condition_of(const Surface_input& input, const Prescription_options& options)
{
  if (!options.tangents_from.empty())
    return directions_of(input, target_surface(input, options.tangents_from),
                         Boundary_condition::tangents().direction);
  if (!options.binormals_from.empty())
    return directions_of(input, target_surface(input, options.binormals_from),
                         Boundary_condition::binormals().direction);
  if (!options.positions_from.empty())
    return positions_of(target_surface(input, options.positions_from),
                        curves_inside(input, options), options.position_weight);
  if (!options.curve.empty())
    return Boundary_condition::tangents(tangents_of_curves(input, options.curve));
  const auto frames = CGP::boundary_frames(input.mesh);
  const CGP::Points T = axes(frames, 0), N = axes(frames, 1), B = axes(frames, 2);
  if (!options.tangent_rotation.empty())  // N x T = -B points into the surface
    return Boundary_condition::tangents(
        turned(T, -B, angles(input, options.tangent_rotation, "--tangent-rotation")));
  return Boundary_condition::binormals(
      turned(B, N, angles(input, options.binormal_tilt, "--binormal-tilt")));
}

}  // namespace

void require_boundary_to_keep(const Surface_input& input, const Boundary_condition& kept)
{
  if (kept.kind != Boundary_condition::Kind::free && CGP::topology(input.mesh).is_closed())
    throw unsuitable(input.file.path,
                     "the surface is closed, and has no boundary to keep; try: without --boundary");
}

Boundary_condition directions_of(const Surface_input& input, const CGP::Mesh_view& target,
                                 const Eigen::Vector3d& direction)
{
  const auto frames = CGP::boundary_frames(target);
  CGP::Points directions(3, count(frames));
  for (Eigen::Index k = 0; k < directions.cols(); ++k)
    directions.col(k) = frames.frames[static_cast<std::size_t>(k)] * direction;
  const auto condition = Boundary_condition::directions(direction, std::move(directions));
  require_directions(input, condition);
  return condition;
}

Boundary_condition prescribed_boundary(const Surface_input& input,
                                       const Prescription_options& options)
{
  Boundary_condition condition = condition_of(input, options);
  require_directions(input, condition);
  return condition;
}

}  // namespace conformal
