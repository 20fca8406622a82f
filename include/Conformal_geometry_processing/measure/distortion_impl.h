// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MEASURE_DISTORTION_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_MEASURE_DISTORTION_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/measure/Distribution.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace Conformal_geometry_processing {

namespace internal {

CGP_INLINE Flat_triangle flattened(const Points& positions, const std::array<int, 3>& corners)
{
  const Eigen::Vector3d u = positions.col(corners[1]) - positions.col(corners[0]);
  const Eigen::Vector3d v = positions.col(corners[2]) - positions.col(corners[0]);
  const double length = u.norm();
  return {length, u.dot(v) / length, u.cross(v).norm() / length};
}

}  // namespace internal

CGP_INLINE Eigen::VectorXd quasi_conformal_errors(const Mesh_view& mesh, const Points& positions)
{
  Eigen::VectorXd Q(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto s = internal::flattened(mesh.positions(), mesh.corners(f));
    const auto t = internal::flattened(positions, mesh.corners(f));
    // The map is the upper triangular matrix (a b; 0 d).
    const double a = t.length / s.length, b = (t.x - a * s.x) / s.y, d = t.y / s.y;
    const double largest = (std::hypot(a + d, b) + std::hypot(a - d, b)) / 2;
    Q[f] = largest / (a * d / largest);  // the smaller one from the determinant: no cancellation
    if (std::isnan(Q[f])) Q[f] = HUGE_VAL;
  }
  return Q;
}

CGP_INLINE internal::Distribution quasi_conformal_error(const Mesh_view& mesh,
                                                        const Points& positions)
{
  return distribution(quasi_conformal_errors(mesh, positions), face_areas(mesh));
}

CGP_INLINE Eigen::VectorXd length_scales(const Mesh_view& mesh, const Points& positions)
{
  Eigen::VectorXd scale(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    scale[f] =
        std::sqrt(mesh.double_area_vector(f, positions).norm() / mesh.double_area_vector(f).norm());
  return scale;
}

namespace internal {

/// the root mean square, which keeps the total area
CGP_INLINE double usual_scale(const Eigen::VectorXd& scale, const Eigen::VectorXd& areas)
{
  return std::sqrt(areas.dot(scale.cwiseAbs2()) / areas.sum());
}

CGP_INLINE double collapsed_share(const Eigen::VectorXd& scale, const Eigen::VectorXd& areas)
{
  const Eigen::VectorXd new_areas = areas.cwiseProduct(scale.cwiseAbs2());
  const double usual = usual_scale(scale, areas);
  const auto shrank = scale.array() < usual / 10;
  const auto grew = scale.array() > usual * 10;
  return (std::max)(shrank.select(areas.array(), 0).sum() / areas.sum(),
                    grew.select(new_areas.array(), 0).sum() / new_areas.sum());
}

}  // namespace internal

CGP_INLINE internal::Area_distortion area_distortion(const Mesh_view& mesh, const Points& positions)
{
  const Eigen::VectorXd scale = length_scales(mesh, positions), areas = face_areas(mesh);
  const Eigen::VectorXd u = scale.array().log();
  const double mean = areas.dot(u) / areas.sum();
  const double variance = areas.dot((u.array() - mean).square().matrix()) / areas.sum();
  internal::Area_distortion d{scale.minCoeff(), scale.maxCoeff(), std::sqrt(variance),
                              internal::collapsed_share(scale, areas)};
  const Eigen::VectorXd octave =
      (scale / internal::usual_scale(scale, areas)).array().log() / std::log(2.);
  d.histogram =
      histogram(octave, areas, static_cast<int>(d.histogram.size()), -d.octaves, d.octaves);
  return d;
}

CGP_INLINE Eigen::VectorXd log_length_cross_ratios(const Mesh_view& mesh, const Points& positions)
{
  Eigen::VectorXd log_length(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    log_length[k] =
        std::log((positions.col(mesh.ends(k)[1]) - positions.col(mesh.ends(k)[0])).norm());
  Eigen::VectorXd ratio = Eigen::VectorXd::Zero(mesh.size_of_edges());
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) >= 0)  // both sides contribute the same quotient l_jk / l_ki
      ratio[mesh.edge(h)] += log_length[mesh.edge(Mesh_view::next_in_face(h))] -
                             log_length[mesh.edge(Mesh_view::previous_in_face(h))];
  return ratio;
}

CGP_INLINE internal::Length_cross_ratio_change length_cross_ratio_change(const Mesh_view& mesh,
                                                                         const Points& positions)
{
  const Eigen::VectorXd change =
      log_length_cross_ratios(mesh, positions) - log_length_cross_ratios(mesh, mesh.positions());
  int interior = 0;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    interior += mesh.halfedges_end(k) - mesh.halfedges_begin(k) == 2;
  if (interior == 0) return {};
  return {change.norm() / std::sqrt(interior), change.cwiseAbs().maxCoeff()};
}

CGP_INLINE Points neighbourhood_normals(const Mesh_view& mesh)
{
  const Points at_vertices = vertex_normals(mesh, internal::Normal_weight::area);
  Points normals(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    normals.col(f) = at_vertices.col(v[0]) + at_vertices.col(v[1]) + at_vertices.col(v[2]);
  }
  return normals;
}

CGP_INLINE Points neighbourhood_normals(const Mesh_view& before, const Points& positions)
{
  Mesh_view after = before;
  after.set_positions(positions);
  const Points old_normals = neighbourhood_normals(before);
  Points normals = neighbourhood_normals(after);
  for (int f = 0; f < before.size_of_faces(); ++f) {
    const double side = before.double_area_vector(f).dot(old_normals.col(f));
    if (side < 0) normals.col(f) *= -1;
    if (side == 0) normals.col(f) = after.double_area_vector(f);
  }
  return normals;
}

CGP_INLINE int flipped_faces(const Mesh_view& mesh, const Points& positions, const Points& expected)
{
  int count = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    count += !(mesh.double_area_vector(f, positions).dot(expected.col(f)) > 0);
  return count;
}

}  // namespace Conformal_geometry_processing

#endif
