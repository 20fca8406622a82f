// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOEBIUS_BALANCING_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOEBIUS_BALANCING_H

#include <Conformal_geometry_processing/algebra/Moebius_map.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief finds, among all sphere inversions of a surface, the one that brings the areas of its
/// vertices nearest to given ones [CGP 4.5.3, 6.4.5.2].
///
/// Curvature does not see Moebius transformations, so a flow by curvature may drift along them
/// until nearly all area is in a few faces. The inversion f -> (f^-1 - a)^-1 of a surface f around
/// the origin changes the logarithm of lengths by -2<a, f> and the curvature potential by -2<a, N>
/// to first order. So with the logarithmic length scale u of the surface against the target, a =
/// 1/2 (sum V f f^T)^-1 sum V u f is what brings sum V u^2 down most; V are the areas of vertices,
/// f is taken from the centroid. The text of [CGP 6.4.4] has another sign and factor, and its step
/// of unit length never comes to rest.
///
/// Balanced surfaces have a = 0. Either the step is added to the curvature potential of a flow
/// (`curvature_change()`), or the inversion is applied exactly (`balanced()`), which repeated
/// converges quadratically, up to O(h^2), and is conformal to rounding. Each step costs O(|V|).
class Moebius_balancing {
 public:
  /// \param target_areas one for each vertex, compared with those of a surface of the same total
  /// area: only their ratios matter
  /// \param function named in exceptions
  /// \throw Precondition_error if one is not positive
  explicit Moebius_balancing(Eigen::VectorXd target_areas,
                             std::string function = "Moebius_balancing")
      : m_target(std::move(target_areas)), m_function(std::move(function))
  {
    for (Eigen::Index v = 0; v < m_target.size(); ++v)
      if (!(m_target[v] > 0) || !std::isfinite(m_target[v]))
        throw Precondition_error(m_function, "the target area of vertex " + std::to_string(v) +
                                                 " is " + std::to_string(m_target[v]) +
                                                 "; positive areas are needed");
  }

  /// \brief u, half the logarithm of area over target area, |V| numbers of mean zero over the
  /// surface: positive where it is too large.
  /// \throw Precondition_error, as all below, if the mesh has another number of vertices
  Eigen::VectorXd log_length_scale(const Mesh_view& mesh) const
  {
    return log_length_scale(areas_of(mesh));
  }

  /// the root of the mean of u^2 over the surface: zero exactly if the areas are those wanted
  double imbalance(const Mesh_view& mesh) const
  {
    const Eigen::VectorXd areas = areas_of(mesh);
    return std::sqrt(areas.dot(log_length_scale(areas).cwiseAbs2()) / areas.sum());
  }

  /// \brief a, in 1/length.
  ///
  /// Shortened where needed, so that the pole of the inversion is twice as far from the centroid as
  /// any vertex; then no length changes by more than a factor of 4.
  Eigen::Vector3d step(const Mesh_view& mesh) const
  {
    const Eigen::VectorXd areas = areas_of(mesh);
    const Points f = mesh.positions().colwise() - centroid(mesh, areas);
    const Eigen::Matrix3d inertia = f * areas.asDiagonal() * f.transpose();
    const Eigen::Vector3d moment = f * areas.cwiseProduct(log_length_scale(areas));
    const Eigen::Vector3d a = inertia.ldlt().solve(moment) / 2;
    const double nearness_of_pole = a.norm() * f.colwise().norm().maxCoeff();
    return a / (std::max)(1., 2 * nearness_of_pole);
  }

  /// \brief -2<a, N>, |V| numbers in 1/length: what the inversion adds to the curvature potential
  /// rho to first order; not to be multiplied by a time step.
  /// \param a `step(mesh)` \param normals 3 x |V| unit normals
  static Eigen::VectorXd curvature_change(const Eigen::Vector3d& a, const Points& normals)
  {
    return -2 * normals.transpose() * a;
  }

  /// \brief the image of the surface under the inversion by `step(mesh)`, with the centroid and the
  /// area of the surface; 3 x |V|.
  ///
  /// Goes back to half the step until the imbalance falls, so that it never rises; returns the
  /// surface as it is where no step helps, as it does when balanced up to rounding.
  Points balanced(const Mesh_view& mesh) const
  {
    const int most_halvings = 6;
    const double before = imbalance(mesh);
    Eigen::Vector3d a = step(mesh);
    Mesh_view image = mesh;
    for (int trial = 0; trial <= most_halvings && a != Eigen::Vector3d::Zero(); ++trial, a /= 2) {
      image.set_positions(inverted(mesh, a));
      if (imbalance(image) < before) return image.positions();
    }
    return mesh.positions();
  }

 private:
  static Points inverted(const Mesh_view& mesh, const Eigen::Vector3d& a)
  {
    const Eigen::VectorXd areas = vertex_areas(mesh);
    const Eigen::Vector3d center = centroid(mesh, areas);
    Mesh_view image = mesh;
    image.set_positions(
        Moebius_map::sphere_inversion(a).transform(mesh.positions().colwise() - center));
    const Eigen::VectorXd new_areas = vertex_areas(image);
    const Eigen::Vector3d new_center = centroid(image, new_areas);
    const double scale = std::sqrt(areas.sum() / new_areas.sum());
    return (scale * (image.positions().colwise() - new_center)).colwise() + center;
  }

  Eigen::VectorXd areas_of(const Mesh_view& mesh) const
  {
    if (mesh.size_of_vertices() != m_target.size())
      throw Precondition_error(m_function, std::to_string(m_target.size()) +
                                               " target areas, one per vertex is needed: " +
                                               std::to_string(mesh.size_of_vertices()));
    return vertex_areas(mesh);
  }

  Eigen::VectorXd log_length_scale(const Eigen::VectorXd& areas) const
  {
    const Eigen::VectorXd u = (areas.array() / m_target.array()).log() / 2;
    return u.array() - areas.dot(u) / areas.sum();
  }

  static Eigen::Vector3d centroid(const Mesh_view& mesh, const Eigen::VectorXd& areas)
  {
    return mesh.positions() * areas / areas.sum();
  }

  Eigen::VectorXd m_target;  // |V|
  std::string m_function;
};

}  // namespace Conformal_geometry_processing

#endif
