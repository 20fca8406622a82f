// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <string>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \brief Part of the boundary whose variance is fixed while the energy is minimized.
enum class Normalized_boundary {
  longest_loop,  ///< shapes and sizes of holes are free
  all_loops
};

/// A closed curve in a mesh, as its vertices in order
using Vertex_loop = std::vector<int>;

}  // namespace internal

/// \ingroup PkgParameterization
/// Returns the arc length of a closed polygon at each of its vertices, and its total length at the
/// end
Eigen::VectorXd lengths_along(const Mesh_view& mesh, const internal::Vertex_loop& loop);

/// \ingroup PkgParameterization
/// \brief Returns the boundary loops in the normalization, the longest one first.
/// \pre the mesh is a manifold with boundary
std::vector<internal::Vertex_loop> normalized_loops(const Mesh_view& mesh,
                                                    internal::Normalized_boundary which);

/// \ingroup PkgParameterization
/// \brief Returns `count` maps of the loops to the plane, zero elsewhere, which wind around the
/// unit circle once, twice, ..., parameterized by arc length; used as initial maps. |V| x count.
Eigen::MatrixXcd circle_maps(const Mesh_view& mesh, const std::vector<internal::Vertex_loop>& loops,
                             int count);

/// \ingroup PkgParameterization
/// \brief Computes tangents of a closed plane curve, as boundary tangents of a disk that is to be
/// flattened by rho = -H: the result of `minimal_surface()` then lies in the plane [CGP 6.5.3].
///
/// The turning angles of the curve are those of the boundary in the surface; the difference of
/// their sum from 2 pi, which by the Gauss-Bonnet theorem is the total curvature of the surface, is
/// distributed evenly along it. A flat disk keeps its shape, and a hemisphere becomes a round disk.
/// Any other directions in the plane with turning number one can be used as well.
/// \code
/// const auto flat =
///     spin_to_minimal_surface(mesh, {Boundary_condition::tangents(planar_directions(mesh))});
/// \endcode
///
/// \returns 3 x number of boundary vertices, unit vectors with z = 0, in the order of
/// `boundary_frames()`; as targets of `Boundary_condition::tangents()`
/// \throw Precondition_error if the mesh is not a disk
/// \pre `require_surface(mesh)` holds
Points planar_directions(const Mesh_view& mesh, const std::string& function = "planar_directions");

}  // namespace Conformal_geometry_processing
