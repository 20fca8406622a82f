// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_BOUNDARY_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_DELAUNAY_BOUNDARY_IMPL_H

#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/delaunay_boundary.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

CGP_INLINE std::vector<std::vector<int>> boundary_loops(const Delaunay_view& mesh)
{
  return mesh.boundary_loops();
}

CGP_INLINE double mean_edge_length(const Delaunay_view& mesh)
{
  double sum = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    sum += (mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0])).norm();
  return sum / mesh.size_of_edges();
}

CGP_INLINE Points vertex_normals(const Delaunay_view& mesh)
{
  Points normals = Points::Zero(3, mesh.size_of_vertices());
  for (const Delaunay_view::Sheet& sheet : mesh.sheets()) {
    const Eigen::Vector3d n =
        stable_normalized(Eigen::Vector3d(sheet.edges.col(0)).cross(sheet.edges.col(1)));
    for (int c = 0; c < 3; ++c)
      normals.col(mesh.corners(sheet.triangle)[static_cast<std::size_t>(c)]) +=
          sheet.share * std::atan2(1, mesh.cotangent(sheet.triangle, c)) * n;
  }
  for (Eigen::Index v = 0; v < normals.cols(); ++v)
    normals.col(v) = stable_normalized(normals.col(v));
  return normals;
}

CGP_INLINE Boundary_frames boundary_frames(const Delaunay_view& mesh)
{
  return boundary_frames(mesh.positions(), vertex_normals(mesh), mesh.boundary_loops());
}

}  // namespace Conformal_geometry_processing

#endif
