// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// Returns the lengths of the edges, |E|
Eigen::VectorXd edge_lengths(const Mesh_view& mesh);

namespace internal {

/// \ingroup PkgMesh
/// Edge lengths without degenerate triangles
struct Mollified_lengths {
  Eigen::VectorXd lengths;  ///< |E|
  double added = 0;         ///< length added to each edge
  int thin_faces = 0;       ///< number of faces that violated the triangle inequality
};

}  // namespace internal

/// \ingroup PkgMesh
/// \brief Mollifies the edge lengths: adds the smallest constant to all of them such that in every
/// triangle the longest edge is shorter than the sum of the two others by at least `share` times
/// the mean length [Sharp and Crane 2020, 4.5].
///
/// Then no triangle is degenerate, even if points are collinear or coincide. The lengths of a mesh
/// without degenerate triangles are unchanged to the bit. A triangle of three collinear points gets
/// a height of about the square root of `share` times its length, two coinciding points a distance
/// of `share`. \param share positive; below about 1e-12, rounding determines the shape of triangles
internal::Mollified_lengths mollified_lengths(const Mesh_view& mesh, double share);

}  // namespace Conformal_geometry_processing
