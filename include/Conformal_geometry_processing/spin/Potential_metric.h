// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/linear_algebra/dense/Solver_status.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the inner product K = M + s L of changes of rho, which approximates
///
///     integral a b + s <grad a, grad b>,
///
/// and the solution of K d = b. With s > 0, the d that is nearest to a given one in this norm has
/// no part that oscillates from vertex to vertex unless the given one has.
///
/// M are the areas. For rho on vertices, L is the cotan Laplacian. For rho on faces, it measures
/// the variance of rho around each vertex v,
///
///     <rho, L rho> = 3 sqrt(3) sum_v 1 / A_v sum_f a_vf (rho_f - mean_v(rho))^2,
///
/// with a_vf a third of the area of f, A_v their sum, and mean_v the mean weighted by a_vf. The
/// factor makes it exact for linear functions on equilateral triangles; on other meshes it is only
/// equivalent to the integral. L annihilates constants.
///
/// Costs the factorization of one scalar matrix with a row for each vertex, also for faces: there K
/// is a diagonal matrix less one whose rank is the number of vertices. `couple()` adds to what is
/// solved, at the same cost, what changes of rho do to the Dirac equation of some spins.
class Potential_metric {
 public:
  /// when the matrix is factored first: at once, or by `couple()`
  enum class Factor { now, later };

  /// \param system whose surface is meant, and whose analysis is shared
  /// \param s >= 0, in the unit of area of the system
  /// \throw Solver_error if the factorization fails
  Potential_metric(const Dirac_system& system, Curvature_potential::On on, double s,
                   Factor factor = Factor::now);

  /// \brief from now on `solve()` is that of H = K + alpha N^T M N with N d = B(d lambda), see
  /// `Dirac_linearization`; K itself stays.
  /// \throw Solver_error if the factorization fails
  void couple(const Quaternion_vector<double>& lambda, double alpha);

  /// M, |V| or |F|
  const Eigen::VectorXd& areas() const { return m_areas; }

  /// K d, for each column of d
  Eigen::MatrixXd apply(const Eigen::MatrixXd& d) const;

  /// \brief K^-1 b, or H^-1 b, for each column of b.
  /// \throw Solver_error if the solver fails
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

  /// <d, K d>
  double squared_norm(const Eigen::VectorXd& d) const { return d.dot(apply(d).col(0)); }

 private:
  void assemble_on_vertices(const Surface_ref& surface, double s);
  void assemble_on_faces(const Surface_ref& surface, double s);
  void couple_on_vertices(const Quaternion_vector<double>& lambda, double alpha);
  void couple_on_faces(const Quaternion_vector<double>& lambda, double alpha);
  static void check(Solver_status status);

  Surface_ref m_surface;
  Eigen::VectorXd m_areas;
  Eigen::VectorXd m_diagonal;                // for faces
  Eigen::VectorXd m_solved_diagonal;         // of K or H, for faces
  Eigen::SparseMatrix<double> m_shares;      // sqrt(3 sqrt(3) s) a_vf / A_v, |V| x |F|, for faces
  Hermitian_sparse_matrix<double> m_matrix;  // K, for vertices
  Solver_ref<double> m_solver;  // of K or H, or of 1 - shares solved_diagonal^-1 shares^T
};

}  // namespace Conformal_geometry_processing::internal
