// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_MEAN_CURVATURE_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_MEAN_CURVATURE_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/divergence.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE void fill_boundary(const Mesh_view& mesh, Eigen::VectorXd& values)
{
  std::vector<char> is_unknown = boundary_vertices(mesh);
  const auto unknown = [&](int v) -> char& { return is_unknown[static_cast<std::size_t>(v)]; };
  for (bool has_changed = true; has_changed;) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(values.size()), count = sum;
    for (int k = 0; k < mesh.size_of_edges(); ++k)
      for (int end = 0; end < 2; ++end) {
        const int v = mesh.ends(k)[end == 0], u = mesh.ends(k)[end == 1];
        if (unknown(v) && !unknown(u)) sum[v] += values[u], count[v] += 1;
      }
    has_changed = false;
    for (int v = 0; v < mesh.size_of_vertices(); ++v) {
      if (count[v] == 0) continue;
      values[v] = sum[v] / count[v];
      unknown(v) = 0;
      has_changed = true;
    }
  }
}

}  // namespace internal

CGP_INLINE Eigen::VectorXd mean_curvature(const Mesh_view& mesh)
{
  const Eigen::VectorXd w = cotan_weights(mesh), areas = voronoi_areas(mesh);
  const Points normals = vertex_normals(mesh, Normal_weight::angle);
  Eigen::MatrixX3d edges(mesh.size_of_edges(), 3);
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    edges.row(k) = (mesh.position(mesh.ends(k)[1]) - mesh.position(mesh.ends(k)[0])).transpose();
  const Eigen::MatrixX3d Lf = codifferential(mesh, w, edges);
  Eigen::VectorXd H(mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    H[v] = Lf.row(v).dot(normals.col(v)) / (2 * areas[v]);
  internal::fill_boundary(mesh, H);
  return H;
}

CGP_INLINE Eigen::VectorXd mean_curvature_half_density(const Mesh_view& mesh)
{
  return mean_curvature(mesh).cwiseProduct(voronoi_areas(mesh).cwiseSqrt());
}

}  // namespace Conformal_geometry_processing

#endif
