// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

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

}  // namespace Conformal_geometry_processing
