// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_MOLLIFIED_LENGTHS_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_MOLLIFIED_LENGTHS_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// the lengths of the edges, |E|
inline Eigen::VectorXd edge_lengths(const Mesh_view& mesh)
{
  Eigen::VectorXd lengths(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    lengths[k] = (mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0])).stableNorm();
  return lengths;
}

/// \ingroup PkgMesh
/// \brief the lengths of the edges, and to all of them the least number added with which the
/// longest edge of every triangle is shorter than the two others together by `share` of the mean
/// length at least [Sharp and Crane 2020, 4.5].
///
/// So no triangle is degenerate, however close the points are to a line, or to each other. A mesh
/// without such triangles keeps its lengths to the bit. A triangle of three points on a line
/// becomes about as high as the root of `share` times its length, two points in one as distant as
/// `share`. \param share positive; rounding decides on the shape of triangles below some 1e-12
inline Eigen::VectorXd mollified_lengths(const Mesh_view& mesh, double share)
{
  Eigen::VectorXd lengths = edge_lengths(mesh);
  const double slack = share * lengths.mean();
  double missing = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    Eigen::Vector3d l;
    for (int c = 0; c < 3; ++c) l[c] = lengths[mesh.edge(3 * f + c)];
    missing = std::max(missing, slack + 2 * l.maxCoeff() - l.sum());
  }
  return lengths.array() + missing;
}

}  // namespace Conformal_geometry_processing

#endif
