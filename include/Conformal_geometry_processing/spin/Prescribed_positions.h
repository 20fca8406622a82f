// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Dirichlet_solver.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief spins and positions of a surface whose boundary is mapped to a given curve with given
/// normals [CGP 6.3.2].
///
/// At the boundary lambda is known: it rotates the frame of the surface into that of the curve and
/// scales by the ratio of lengths. Inside it minimises |(D - rho) lambda|^2, which is a linear
/// system. Spins of opposite signs have the same positions, so each loop has a sign of its own, of
/// which those with the least energy belong to the surface. The positions solve (5.5) with the
/// boundary fixed on the curve. Curves inside the surface are treated in the same way. With a
/// finite weight w, both minimise in addition w / R times the integral along the boundary of the
/// squared difference from what is given, where pi R^2 is the area.
///
class Prescribed_positions {
 public:
  /// \param surface must outlive the object
  /// \param condition of kind `positions`
  /// \param pattern `vertex_graph(surface)`
  /// \param solver of the same traits; its symbolic analysis is shared
  /// \throw Precondition_error if no continuous lambda exists, because the normals of the curve
  /// make one turn too many relative to those of the surface (their spin structures differ); if the
  /// curve folds back at a vertex, or its normal is parallel to it
  Prescribed_positions(const Surface_ref& surface, const Boundary_condition& condition,
                       std::shared_ptr<const Sparse_pattern> pattern,
                       const Solver_ref<Quaternion<double>>& solver, const std::string& function)
      : m_surface(surface),
        m_frames(frames_of(surface, condition)),
        m_targets(condition.targets),
        m_weights(weights(condition.weight)),
        m_spins(spins(condition, function)),
        m_lambda(pattern, m_frames.vertices, solver),
        m_positions(std::move(pattern), m_frames.vertices, solver)
  {}

  /// \brief factors the interior part of X.
  /// \throw Solver_error if the factorization fails
  void factorize(const Hermitian_sparse_matrix<Quaternion<double>>& X) { factorize(m_lambda, X); }

  /// \brief lambda, |V|: the minimiser of the energy with the given values at the boundary, whose
  /// signs it chooses
  /// \pre X has been factorized
  Quaternion_vector<double> spins(const Hermitian_sparse_matrix<Quaternion<double>>& X);

  /// residual of the linear system, relative to the contribution of the boundary
  double residual(const Hermitian_sparse_matrix<Quaternion<double>>& X,
                  const Quaternion_vector<double>& lambda) const;

  /// the positions that fit the edges best with the boundary on the curve; 3 x |V|
  /// \throw Solver_error if the Laplacian cannot be factored
  Points positions(const Eigen::MatrixX3d& edges);

  /// how far each boundary vertex is from the curve
  Eigen::VectorXd errors(const Points& f) const;

 private:
  /// w / R times the length of the boundary at each vertex; empty if positions are exact
  Eigen::VectorXd weights(double weight) const;

  template <class Solver, class Matrix>
  void factorize(Solver& solver, const Matrix& A)
  {
    m_weights.size() > 0 ? solver.factorize(A, m_weights) : solver.factorize(A);
  }

  /// zero but on a loop, each of which has a column
  Block<Quaternion<double>> given_spins() const;

  /// \brief the signs of loops, one after another, of which the next is the loop that changes the
  /// energy most
  /// \param S the energy as a quadratic form of the signs
  static Eigen::VectorXd signs(const Eigen::MatrixXd& S);

  std::vector<Quaternion<double>> spins(const Boundary_condition& condition,
                                        const std::string& function) const;

  /// \param first index of the first vertex of the loop among all boundary vertices
  Quaternion<double> spin_at(const Boundary_condition& condition, std::size_t first,
                             const std::vector<int>& loop, std::size_t k,
                             const std::string& function) const;

  Surface_ref m_surface;
  Boundary_frames m_frames;
  Points m_targets;
  Eigen::VectorXd m_weights;  // |V|
  std::vector<Quaternion<double>> m_spins;
  Dirichlet_solver<Quaternion<double>> m_lambda;
  Dirichlet_solver<double> m_positions;
};

}  // namespace Conformal_geometry_processing::internal
