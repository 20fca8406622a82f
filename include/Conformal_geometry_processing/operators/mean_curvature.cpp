// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {
namespace internal {

void fill_unknown(const Surface_ref& surface, std::vector<char> is_unknown, Eigen::VectorXd& values)
{
  const auto unknown = [&](int v) -> char& { return is_unknown[static_cast<std::size_t>(v)]; };
  for (bool has_changed = true; has_changed;) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(values.size()), count = sum;
    for (int k = 0; k < surface.size_of_edges(); ++k)
      for (int end = 0; end < 2; ++end) {
        const int v = surface.ends(k)[end == 0], u = surface.ends(k)[end == 1];
        if (unknown(v) && !unknown(u)) sum[v] += values[u], count[v] += 1;
      }
    has_changed = false;
    for (int v = 0; v < surface.size_of_vertices(); ++v) {
      if (count[v] == 0) continue;
      values[v] = sum[v] / count[v];
      unknown(v) = 0;
      has_changed = true;
    }
  }
}

/// the vertices on the boundary, or of nearly zero area
std::vector<char> without_curvature(const Surface_ref& surface, const Eigen::VectorXd& areas)
{
  std::vector<char> is_without = boundary_vertices(surface);
  for (int k = 0; k < surface.size_of_edges(); ++k)
    for (int end = 0; end < 2; ++end) {
      const int v = surface.ends(k)[end == 0], u = surface.ends(k)[end == 1];
      if (areas[v] < 1e-3 * areas[u]) is_without[static_cast<std::size_t>(v)] = 1;
    }
  // The apex of a cap at the boundary: its triangle is two, between which the boundary runs now.
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    for (std::size_t c = 0; c < 3; ++c)
      if (sheet.corners[c] == sheet.corners[(c + 1) % 3])
        is_without[static_cast<std::size_t>(sheet.corners[c])] = 1;
  }
  return is_without;
}

Eigen::VectorXd angle_defects(const Mesh_view& mesh)
{
  const double pi = std::acos(-1.);
  Eigen::VectorXd defects = Eigen::VectorXd::Constant(mesh.size_of_vertices(), 2 * pi);
  for (int h = 0; h < mesh.size_of_halfedges(); ++h) {
    if (mesh.twin(h) < 0) defects[mesh.from(h)] -= pi;
    defects[mesh.corners()[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)]] -=
        corner_angle(mesh.sheet(h / 3), h % 3);
  }
  return defects;
}

}  // namespace internal

Eigen::VectorXd mean_curvature(const Surface_ref& surface)
{
  const Eigen::VectorXd w = cotan_weights(surface), areas = voronoi_areas(surface);
  const Points normals = vertex_normals(surface, internal::Normal_weight::angle);
  Eigen::MatrixX3d edges(surface.size_of_edges(), 3);
  for (int k = 0; k < surface.size_of_edges(); ++k)
    edges.row(k) =
        (surface.position(surface.ends(k)[1]) - surface.position(surface.ends(k)[0])).transpose();
  const Eigen::MatrixX3d Lf = codifferential(surface, w, edges);
  Eigen::VectorXd H(surface.size_of_vertices());
  for (int v = 0; v < surface.size_of_vertices(); ++v)
    H[v] = Lf.row(v).dot(normals.col(v)) / (2 * areas[v]);
  internal::fill_unknown(surface, internal::without_curvature(surface, areas), H);
  return H;
}

Eigen::VectorXd mean_curvature_half_density(const Surface_ref& surface)
{
  return mean_curvature(surface).cwiseProduct(voronoi_areas(surface).cwiseSqrt());
}

}  // namespace Conformal_geometry_processing
