// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/painting/image_filters.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

namespace internal {

/// \brief high-pass filter for a function on the vertices, such as the direction of a curvature
/// flow, which then preserves the large features of the surface [CGP 6.4.2.1].
///
/// v -> v - (id + sigma Delta^k)^-1 v with the positive semidefinite Laplacian Delta = M_V^-1 L. An
/// eigenfunction of eigenvalue l is multiplied by sigma l^k / (1 + sigma l^k): constants vanish,
/// and the larger the order k, the sharper the cut-off at l = sigma^(-1/k). Order 0 multiplies all
/// functions by sigma / (1 + sigma). [CGP 6.4.2.1] has id - sigma Delta^k, which is indefinite.
///
/// sigma refers to the surface scaled to the area 4 pi, where the eigenvalues of the round sphere
/// are l = n (n + 1) for degree n; sigma is therefore dimensionless and independent of the scale of
/// the mesh.
///
/// Delta^k is never assembled: it couples vertices k edges apart, and its condition number is that
/// of L to the power k, which destroys all digits on meshes with small faces. Instead, with the
/// bounded operator C = (id + sigma^(1/k) Delta)^-1, the filter is (1 - C)^k / (C^k + (1 - C)^k), a
/// smooth function of C on [0, 1], which is evaluated by its Chebyshev series, truncated below
/// 1e-10. The matrix of C has the pattern of the mesh and is factored in the constructor and by
/// `update_geometry()`; a call costs 1, 27, 42, 58 solves for the orders 1, 2, 3, 4.
///
class Curvature_filter {
 public:
  /// \param surface must outlive the object
  /// \param weight sigma > 0
  /// \param order k >= 0
  /// \pre `require_surface()` of the mesh holds
  /// \throw Precondition_error if weight or order are out of range
  /// \throw Solver_error if the matrix cannot be factored
  Curvature_filter(const Surface_ref& surface, double weight, int order,
                   const Spin_solvers& solvers = {});

  /// shares the symbolic analysis of another solver with the same pattern
  /// \param pattern `vertex_graph(surface)`
  /// \param other a `Solver` of the same traits, for any scalar
  template <class Scalar>
  Curvature_filter(const Surface_ref& surface, double weight, int order,
                   std::shared_ptr<const Sparse_pattern> pattern, const Solver_ref<Scalar>& other)
      : Curvature_filter(surface, weight, order, std::move(pattern),
                         other.template another<double>())
  {
    check("analysis", m_solver.analyze_like(m_L.pattern(), other));
    update_geometry();
  }

  /// \brief adopts new positions of the mesh: factors again with the same symbolic analysis.
  /// \throw Solver_error if the matrix cannot be factored
  void update_geometry();

  /// the filtered function
  /// \param v |V| numbers
  /// \throw Solver_error if the solver fails
  Eigen::VectorXd operator()(const Eigen::VectorXd& v) const;

 private:
  Curvature_filter(const Surface_ref& surface, double weight, int order,
                   std::shared_ptr<const Sparse_pattern> pattern, Solver_ref<double>&& solver);

  /// C v
  Eigen::VectorXd smoothed(const Eigen::VectorXd& v) const;

  /// The Chebyshev coefficients of (1 - c)^k / (c^k + (1 - c)^k) in t = 2c - 1. Its poles nearest
  /// to [-1, 1] are at +-i tan(pi / 2k), so the terms decay like 1 / (sum of the half axes of that
  /// ellipse)^j.
  static Eigen::VectorXd gain_series(int k);
  static void check(const char* step, Solver_status status);

  Surface_ref m_surface;
  double m_weight;
  int m_order;
  Hermitian_sparse_matrix<double> m_L;
  Eigen::VectorXd m_series;  // the coefficients of the filter
  Eigen::VectorXd m_masses;  // |V|; C = (L + diag(m_masses))^-1 diag(m_masses)
  Solver_ref<double> m_solver;
};

}  // namespace internal

/// \ingroup PkgFlow
/// options of `filtered_on_surface()`
struct Filter_options {
  double weight = 0.01;  ///< sigma > 0, on the surface scaled to the area 4 pi: features larger
                         ///< than about sigma^(1/(2 order)) count as large
  int order = 1;         ///< k >= 0, the sharpness of the cut-off
  double amount = 1;     ///< of `Curvature_band::unsharp`
};

/// \ingroup PkgFlow
/// \brief filters a function on the vertices, such as rho or a height, by its frequencies on the
/// surface: the high part of an eigenfunction of the Laplacian with eigenvalue l is its share h =
/// sigma l^k / (1 + sigma l^k), see `Curvature_filter`; low-pass is (id + sigma Delta^k)^-1.
/// \param v |V| numbers
/// \pre `require_surface(mesh)` holds
/// \throw Precondition_error if weight or order are out of range
/// \throw Solver_error if a factorization fails
inline Eigen::VectorXd filtered_on_surface(const Mesh_view& mesh, const Eigen::VectorXd& v,
                                           Curvature_band band, const Filter_options& options = {},
                                           const Spin_solvers& solvers = {})
{
  const Points& positions = mesh.positions();
  const Mesh_view in_frame(internal::Normalized_frame(positions).to_frame(positions),
                           mesh.corners());
  const internal::Curvature_filter filter(in_frame, options.weight, options.order, solvers);
  return band_of(v, filter(v), band, options.amount);
}

namespace internal {

/// \brief points of a flow that suit the faces of its input.
///
/// Where faces are thin, what is smooth on the triangulation of the flow may be rough on them, as
/// the same points are joined by other edges, and steps cannot smooth faces of the triangulation
/// that are thin themselves, of prisms for instance. That roughness is as narrow as an edge, so a
/// filter takes it off: with A = (M + S L)^-1 M, the cotan Laplacian L and vertex areas M of the
/// input, and S their mean,
///
///     f - (1 - A)^2 f,
///
/// which leaves what is wide as it is, up to the fourth power of the edge length by the width. L
/// does not depend on scale, so an edge is as wide as another however the surface has changed.
class Face_filter {
 public:
  /// \param input closed. Costs one factorization of a real matrix
  /// \throw Solver_error if the matrix cannot be factored
  Face_filter(const Mesh_view& input, const Spin_solvers& solvers);

  /// \brief the filtered positions, 3 x |V|, with the same mean by the vertex areas of the input.
  /// Costs two solutions.
  Points settled(const Points& positions) const;

 private:
  Points averaged(const Points& positions) const;  // A f

  Eigen::VectorXd m_masses;  // M / S
  Solver_ref<double> m_solver;
};

}  // namespace internal

}  // namespace Conformal_geometry_processing
