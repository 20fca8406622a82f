// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief the right-handed orthonormal frame (T, N, B) of a surface at a vertex of its boundary, in
/// columns: T along the boundary with the surface on its left, N the normal, B = T x N pointing out
/// of the surface.
using Boundary_frame = Eigen::Matrix3d;

/// \brief the boundary vertices of a surface in order, with a frame at each.
///
/// T is the `circle_tangent()`. N is the angle-weighted normal of the vertex, made orthogonal to T.
/// If the boundary is folded so that T or N vanishes, the frame is zero.
struct Boundary_frames {
  std::vector<std::vector<int>> loops;  ///< see `boundary_loops()`
  std::vector<int> vertices;            ///< all of them, loop after loop
  std::vector<Boundary_frame> frames;   ///< one for each of `vertices`

  Eigen::Vector3d tangent(std::size_t k) const { return frames[k].col(0); }
  Eigen::Vector3d normal(std::size_t k) const { return frames[k].col(1); }
  Eigen::Vector3d binormal(std::size_t k) const { return frames[k].col(2); }
};

/// \brief the closed curves of edges that marked vertices form, each with its vertices in order.
///
/// A curve begins at its vertex of smallest number. O(|V| + |E|).
/// \param is_marked |V|
/// \param name of a vertex in errors
/// \throw Precondition_error if a marked vertex has more or fewer than two marked neighbours
std::vector<std::vector<int>> closed_curves(
    const Mesh_view& mesh, const std::vector<char>& is_marked, const std::string& function,
    const std::function<std::string(int)>& name = name_of_vertex);

}  // namespace internal

/// \ingroup PkgMesh
/// \brief the tangent at `here` of the circle through three points, of no particular length; zero
/// if the curve folds back.
///
/// It is second order on any smooth curve. The direction from the previous to the next point is so
/// only where edges grow steadily; where they jump it is first order, as the outgoing edge is.
Eigen::Vector3d circle_tangent(const Eigen::Vector3d& previous, const Eigen::Vector3d& here,
                               const Eigen::Vector3d& next);

/// \ingroup PkgMesh
/// the frame of a tangent and a normal, which need not be unit vectors or orthogonal
internal::Boundary_frame boundary_frame(const Eigen::Vector3d& tangent,
                                        const Eigen::Vector3d& normal);

/// \ingroup PkgMesh
/// the frames of closed curves on a surface, each with its vertices in order; O(|V| + |F|)
internal::Boundary_frames frames_along(const Surface_ref& surface,
                                       std::vector<std::vector<int>> loops);

/// \ingroup PkgMesh
/// the frames of all boundary vertices; O(|V| + |F|)
/// \pre `require_surface(mesh)` holds
internal::Boundary_frames boundary_frames(const Surface_ref& surface);

}  // namespace Conformal_geometry_processing
