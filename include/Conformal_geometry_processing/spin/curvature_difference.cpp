// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/curvature_difference.h>

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

Curvature_potential curvature_difference(const Mesh_view& mesh, const Points& positions)
{
  if (positions.cols() != mesh.size_of_vertices())
    throw Precondition_error("curvature_difference", std::to_string(positions.cols()) +
                                                         " positions, one per vertex is needed: " +
                                                         std::to_string(mesh.size_of_vertices()));
  const internal::Normalized_frame frame(mesh.positions());
  const Mesh_view before = internal::in_own_frame(mesh);
  Mesh_view after = before;
  after.set_positions(internal::Normalized_frame(positions).to_frame(positions));
  const Eigen::VectorXd change =
      mean_curvature_half_density(after) - mean_curvature_half_density(before);
  return Curvature_potential::on_vertices(
      change.cwiseQuotient(frame.unit() * voronoi_areas(before).cwiseSqrt()));
}

Curvature_potential transferred(const Curvature_potential& rho, const Mesh_view& from,
                                const Mesh_view& to)
{
  const double unit = internal::Normalized_frame(from.positions()).unit() /
                      internal::Normalized_frame(to.positions()).unit();
  const auto areas = [&rho](const Mesh_view& mesh) -> Eigen::VectorXd {
    const Mesh_view own = internal::in_own_frame(mesh);
    return rho.on == Curvature_potential::On::faces ? face_areas(own) : voronoi_areas(own);
  };
  const Eigen::VectorXd shrinking = areas(from).cwiseQuotient(areas(to)).cwiseSqrt();
  return {rho.on, unit * rho.values.cwiseProduct(shrinking)};
}

Points turned_binormals(const Mesh_view& from, const Mesh_view& to, const Mesh_view& start,
                        double t)
{
  const internal::Boundary_frames F = boundary_frames(from), G = boundary_frames(to),
                                  S = boundary_frames(start);
  Points turned(3, static_cast<Eigen::Index>(S.vertices.size()));
  for (std::size_t k = 0; k < S.vertices.size(); ++k) {
    const Eigen::Vector3d end = F.frames[k].transpose() * G.binormal(k);
    const double sine = std::hypot(end.x(), end.y()), angle = std::atan2(sine, end.z());
    // A half turn passes through the normal.
    const Eigen::Vector3d side =
        sine > 0 ? Eigen::Vector3d(end.x() / sine, end.y() / sine, 0) : Eigen::Vector3d::UnitY();
    turned.col(static_cast<Eigen::Index>(k)) =
        S.frames[k] * (std::cos(t * angle) * Eigen::Vector3d::UnitZ() + std::sin(t * angle) * side);
  }
  return turned;
}

Spin_transformation_options blend_request(const Mesh_view& from, const Points& to,
                                          const Mesh_view& start, double t,
                                          Spin_transformation_options request)
{
  if (topology(start).is_closed()) return request;
  const Mesh_view aligned(align(to, from.positions()).apply(to), from.corners());
  request.boundary = Boundary_condition::binormals(turned_binormals(from, aligned, start, t));
  request.exactness.reset();
  return request;
}

namespace internal {

/// \brief rho changed so that transformations by it arrive: the spins of a fit are not an
/// eigenvector of its rho. The difference of curvature misses a surface by O(h^2), and corrections
/// by as much of themselves, so that each of the few is far smaller than the last one; but on
/// nearly round spheres these do not see the inversions of space, which hardly change curvature
/// there.
Curvature_potential corrected(const Mesh_view& mesh, Curvature_potential rho, const Points& wanted,
                              double tolerance, const Dirac_options& options,
                              const Go_further& go_further)
{
  const int max_corrections = 6;
  Spin_transformation_options request;
  request.dirac = options;
  Spin_transformation transformation(mesh, blend_request(mesh, wanted, mesh, 1, request));
  const Eigen::VectorXd curvature = curvature_difference(mesh, wanted).values;
  Curvature_potential best = rho;
  for (double least = std::numeric_limits<double>::infinity(), i = 0; i < max_corrections; ++i) {
    const Spin_result r = transformation.transform(rho, go_further);
    if (!r.report.converged || r.report.cancelled) break;
    const double distance = align(r.positions, wanted).rms;
    if (!(distance < least)) break;
    const bool is_slow = distance > .9 * least;
    least = distance;
    best = rho;
    if (distance <= tolerance || is_slow) break;
    rho.values += curvature - curvature_difference(mesh, r.positions).values;
  }
  return best;
}

/// M_V^-1 B^T M_F B rho: the means of rho on faces, averaged around vertices
Eigen::VectorXd averaged_over_faces(const Mesh_view& mesh, const Eigen::VectorXd& rho)
{
  const Eigen::VectorXd areas = face_areas(mesh);
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(rho.size());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    double mean = 0;
    for (const int v : mesh.corners(f)) mean += rho[v] / 3;
    for (const int v : mesh.corners(f)) sums[v] += areas[f] * mean / 3;
  }
  return sums.cwiseQuotient(vertex_areas(mesh));
}

}  // namespace internal

Curvature_potential nearest_curvature_difference(const Mesh_view& mesh, const Points& positions,
                                                 double distance_tolerance,
                                                 const Dirac_options& options,
                                                 const internal::Go_further& go_further,
                                                 const std::string& function)
{
  Nearest_spin_options own;
  own.direction = {0, 0, 1};
  own.distance_tolerance = distance_tolerance;
  own.surface.dirac = options;
  Nearest_spin_transformation search(mesh, positions, function, own);
  Nearest_spin_result found = search.transform(go_further);
  const bool has_binormals = topology(mesh).is_closed() || found.direction == own.direction;
  if (found.report && found.distance < found.source_distance && has_binormals)
    return internal::corrected(mesh, std::move(found.rho), found.positions, distance_tolerance,
                               options, go_further);
  return curvature_difference(mesh, positions);
}

Curvature_potential curvature_of_displacement(const Mesh_view& mesh, const Eigen::VectorXd& height)
{
  if (height.size() != mesh.size_of_vertices())
    throw Precondition_error(
        "curvature_of_displacement",
        std::to_string(height.size()) +
            " heights, one per vertex is needed: " + std::to_string(mesh.size_of_vertices()));
  const Eigen::VectorXd slope = exterior_derivative_0(mesh) * height;
  const Eigen::VectorXd Lh = codifferential(mesh, cotan_weights(mesh), slope);
  Eigen::VectorXd rho = Lh.cwiseQuotient(2 * vertex_areas(mesh));
  internal::fill_unknown(mesh, boundary_vertices(mesh), rho);
  // The equation sees the means of rho on faces only. They are lower than the peaks that a bump of
  // a few edges has; a step of Richardson's iteration against the averaging makes up for that.
  rho += rho - internal::averaged_over_faces(mesh, rho);
  internal::fill_unknown(mesh, boundary_vertices(mesh), rho);
  return Curvature_potential::on_vertices(std::move(rho));
}

}  // namespace Conformal_geometry_processing
