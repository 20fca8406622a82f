// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>

#include <Eigen/Core>

#include <array>
#include <memory>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief The lengths l_ij of a mesh, from which those of a surface are to differ by factors at the
/// vertices: |f_j - f_i| = l_ij exp((u_i + u_j) / 2), discrete conformal equivalence.
///
/// Of the edges with a free end; vertices that are not free are held, with u = 0. All functions are
/// invariant under motions of f; scaling of f, where all vertices are free, adds a constant to u.
class Edge_scales {
 public:
  struct Edge {
    std::array<int, 2> ends, free;  ///< vertices; their numbers among the free ones, or -1
    double log_length;
  };

  /// \param free the number of each vertex among the free ones, -1 for those that are held
  Edge_scales(const Mesh_view& mesh, const std::vector<int>& free);

  /// of all edges, every vertex being free
  explicit Edge_scales(const Mesh_view& mesh);

  const std::vector<Edge>& edges() const { return m_edges; }

  /// \brief c_ij = log |f_j - f_i| - log l_ij - (u_i + u_j) / 2, for each edge; not finite where an
  /// edge has no length.
  Eigen::VectorXd residuals(const Points& f, const Eigen::VectorXd& u) const;

  /// \brief How exactly positions in double precision can hold the residuals: the largest change of
  /// log |f_j - f_i| when coordinates of the ends are rounded.
  double rounding(const Points& f) const;

  /// \brief The u of least squares of the residuals.
  ///
  /// Its normal equations, the signless Laplacian, are well conditioned on every mesh with
  /// triangles: conjugate gradients need about 30 products.
  /// \pre all vertices are free
  /// \throw Solver_error if an edge of f has no length
  Eigen::VectorXd nearest_scales(const Points& f) const;

 private:
  std::vector<Edge> m_edges;
};

/// \brief Factors a matrix of a least-squares problem; where rounding has made it indefinite, with
/// a share of its diagonal in addition that mends it, smaller than `most`: a step is shorter then.
Solver_status factorize_definite(Supernodal_cholesky<double>& solver,
                                 const Hermitian_sparse_matrix<double>& A, double most);

/// \brief The quadratic form of a step (df, du) near the discrete conformal class of a mesh, with
/// w |J (df, du)|^2 in it for the derivative J of the residuals of `Edge_scales`.
///
/// Real, symmetric, 4|free| x 4|free|, with blocks of 4 x 4 numbers: three for the position of a
/// free vertex, one for its log scale.
class Class_form {
 public:
  /// \param graph a pattern of the free vertices that contains their edges
  Class_form(Edge_scales scales, const Sparse_pattern& graph);

  /// \brief Analyzes for many factorizations.
  /// \param positions of the free vertices
  Solver_status analyze(Supernodal_cholesky<double>& solver, const Points& positions) const;

  const Edge_scales& scales() const { return m_scales; }

  /// sets the form to zero, and J to that at f
  void linearize(const Points& f);

  /// adds a block, and its transpose on the other side of the diagonal
  void add(int row, int column, const Eigen::Matrix4d& block);

  /// adds x <df_row, df_column>, twice where these are two vertices
  void add_of_positions(int row, int column, double x)
  {
    add(row, column, Eigen::Vector4d(x, x, x, 0).asDiagonal());
  }

  /// adds x |du_v|^2
  void add_of_scale(int v, double x) { add(v, v, Eigen::Vector4d(0, 0, 0, x).asDiagonal()); }

  /// adds w |J (df, du)|^2
  void add_equations(double w);

  const Hermitian_sparse_matrix<double>& matrix() const { return m_matrix; }

  /// 1 / |f_j - f_i|^2 of each edge: the square of the derivative of its log length
  Eigen::VectorXd inverse_squared_lengths() const { return m_directions.colwise().squaredNorm(); }

  /// -w J^T c, 4|free| x 1
  Block<double> right_hand_side(const Eigen::VectorXd& c) const;

 private:
  Edge_scales m_scales;
  Sparse_pattern m_graph;
  Hermitian_sparse_matrix<double> m_matrix;
  Points m_directions;
  double m_weight = 0;
};

}  // namespace Conformal_geometry_processing::internal
