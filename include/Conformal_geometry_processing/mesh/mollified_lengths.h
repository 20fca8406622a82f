// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_MOLLIFIED_LENGTHS_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_MOLLIFIED_LENGTHS_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// the lengths of the edges, |E|
Eigen::VectorXd edge_lengths(const Mesh_view& mesh);

/// \ingroup PkgMesh
/// lengths of edges with which no triangle is degenerate, and what that took
struct Mollified_lengths {
  Eigen::VectorXd lengths;  ///< |E|
  double added = 0;         ///< to each of them
  int thin_faces = 0;       ///< those that lacked it
};

/// \ingroup PkgMesh
/// \brief the lengths of the edges, and to all of them the least number added with which the
/// longest edge of every triangle is shorter than the two others together by `share` of the mean
/// length at least [Sharp and Crane 2020, 4.5].
///
/// So no triangle is degenerate, however close the points are to a line, or to each other. A mesh
/// without such triangles keeps its lengths to the bit. A triangle of three points on a line
/// becomes about as high as the root of `share` times its length, two points in one as distant as
/// `share`. \param share positive; rounding decides on the shape of triangles below some 1e-12
Mollified_lengths mollified_lengths(const Mesh_view& mesh, double share);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/mollified_lengths_impl.h>
#endif

#endif
