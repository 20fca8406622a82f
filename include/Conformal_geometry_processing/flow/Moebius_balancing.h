// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Flow_options.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/algebra/Moebius_map.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing {

namespace internal {

/// \brief finds the sphere inversion of a surface that brings the areas of its vertices nearest to
/// given ones [CGP 4.5.3, 6.4.5.2].
///
/// Moebius transformations do not change the curvature, so a curvature flow may drift along them
/// until nearly all area is in a few faces. The inversion f -> (f^-1 - a)^-1 of a surface f around
/// the origin changes the logarithm of lengths by -2<a, f> and the curvature potential by -2<a, N>
/// to first order. With the logarithmic length scale u of the surface relative to the target, a =
/// 1/2 (sum V f f^T)^-1 sum V u f therefore minimises sum V u^2; V are the areas of vertices, and f
/// is measured from the centroid. [CGP 6.4.4] has another sign and factor, and its step of unit
/// length does not converge.
///
/// Balanced surfaces have a = 0. Either the step is added to the curvature potential of a flow
/// (`curvature_change()`), or the inversion is applied exactly (`balanced()`); repeated, this
/// converges quadratically, up to O(h^2), and is conformal up to rounding. Each step costs O(|V|).
class Moebius_balancing {
 public:
  /// \param target_areas one for each vertex, scaled to the total area of the surface: only their
  /// ratios matter
  /// \param function named in exceptions
  /// \throw Precondition_error if one is not positive
  explicit Moebius_balancing(Eigen::VectorXd target_areas,
                             std::string function = "Moebius_balancing");

  /// \brief u, half the logarithm of area over target area, |V| numbers with mean zero over the
  /// surface: positive where the area is too large.
  /// \throw Precondition_error, like all functions below, if the number of vertices of the mesh
  /// differs
  Eigen::VectorXd log_length_scale(const Mesh_view& mesh) const;

  /// the root mean square of u over the surface: zero if and only if the areas match the target
  double imbalance(const Mesh_view& mesh) const;

  /// \brief a, in 1/length.
  ///
  /// Shortened if necessary, so that the pole of the inversion is at least twice as far from the
  /// centroid as any vertex; then no length changes by more than a factor of 4.
  Eigen::Vector3d step(const Mesh_view& mesh) const;

  /// \brief -2<a, N>, |V| numbers in 1/length: the first-order change of the curvature potential
  /// rho by the inversion; must not be multiplied by a time step.
  /// \param a `step(mesh)` \param normals 3 x |V| unit normals
  static Eigen::VectorXd curvature_change(const Eigen::Vector3d& a, const Points& normals);

  /// \brief the image of the surface under the inversion by `step(mesh)`, with the centroid and the
  /// area of the surface; 3 x |V|.
  ///
  /// Halves the step until the imbalance decreases, so that it never increases; returns the surface
  /// unchanged if no step helps, as when it is balanced up to rounding.
  Points balanced(const Mesh_view& mesh) const;

 private:
  static Points inverted(const Mesh_view& mesh, const Eigen::Vector3d& a);
  Eigen::VectorXd areas_of(const Mesh_view& mesh) const;
  Eigen::VectorXd log_length_scale(const Eigen::VectorXd& areas) const;
  static Eigen::Vector3d centroid(const Mesh_view& mesh, const Eigen::VectorXd& areas);

  Eigen::VectorXd m_target;  // |V|
  std::string m_function;
};

}  // namespace internal

/// \ingroup PkgFlow
/// \brief u_f = 1/2 sum_i |v_i|^2 over an orthonormal basis of the harmonic fields: the canonical
/// metric is u times that of the surface; one number in 1/area for each sheet, which are the faces
/// of a mesh [CGP 4.5.3, 6.4.5.2].
///
/// u is a density of area, not the logarithm of a scale. Its integral is the genus. u depends only
/// on the conformal structure: conformally equivalent surfaces have the same u dA, and every
/// orthonormal basis gives the same u. Costs O(G |F|).
///
/// \param surface closed
/// \param one_forms an orthonormal basis of the harmonic forms, |E| x 2G
/// \param function named in the exception
/// \throw Precondition_error on a sphere, which has no harmonic forms
Eigen::VectorXd canonical_area_density(const Surface_ref& surface, const Eigen::MatrixXd& one_forms,
                                       const std::string& function = "canonical_area_density");

/// \ingroup PkgFlow
/// \brief the area of each vertex in the canonical metric, a third of the faces around it: |V|
/// numbers that sum up to the genus. The target of `Moebius_balancing`.
///
/// Computed once for a flow, because conformal deformations do not change it.
/// \param density `canonical_area_density()`
Eigen::VectorXd canonical_vertex_areas(const Surface_ref& surface, const Eigen::VectorXd& density);

class Spin_transformation;

namespace internal {

/// \brief keeps a flow balanced as its options specify.
class Flow_balance {
 public:
  /// \param mesh the initial surface of the flow
  /// \param transformation of the mesh
  /// \param function named in exceptions
  /// \throw Precondition_error if a prescribed area is not positive, their number is not that of
  /// the vertices, or the canonical metric of a sphere is requested
  Flow_balance(const Mesh_view& mesh, const Flow_options& options,
               Spin_transformation& transformation, const std::string& function);

  /// \brief the term to be added to the curvature potential of a step, |V| numbers in 1/length;
  /// zero if balance is not kept by a potential.
  ///
  /// Must not be multiplied by the time step: the surface can return in a single step.
  Eigen::VectorXd potential(const Mesh_view& mesh) const;

  /// whether `inverted()` must be applied after a step
  bool is_by_inversion() const
  {
    return m_balancing && m_way == Flow_options::Balancing::inversion;
  }

  /// \brief the balanced image of the surface under sphere inversions, with its area and centroid.
  /// \pre `is_by_inversion()`
  Points inverted(Mesh_view mesh) const;

 private:
  Flow_options::Balancing m_way;
  std::optional<Moebius_balancing> m_balancing;
};

}  // namespace internal

}  // namespace Conformal_geometry_processing
