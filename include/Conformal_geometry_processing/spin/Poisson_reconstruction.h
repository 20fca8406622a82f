// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

#include <memory>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the integral of conjugate(lambda) df lambda along the edge e, with lambda linear from l_i
/// to l_j [CGP (5.4)]:
///
///     e~ = 1/3 l_i^ e l_i + 1/6 l_i^ e l_j + 1/6 l_j^ e l_i + 1/3 l_j^ e l_j,   l^ = conjugate(l),
///
/// which is purely imaginary. Constant lambda gives conjugate(lambda) e lambda exactly.
Eigen::Vector3d transformed_edge(const Eigen::Vector3d& e, const Quaternion<double>& l_i,
                                 const Quaternion<double>& l_j);

/// \ingroup PkgSpin
/// \brief the edge vectors of the spin transformed surface, df~ = conjugate(lambda) df lambda
/// integrated along each edge; |E| x 3, edge k runs i -> j with i < j.
/// \param lambda |V| quaternions
Eigen::MatrixX3d transformed_edges(const Surface_ref& surface,
                                   const Quaternion_vector<double>& lambda);

namespace internal {

/// \brief |d0 f - e| / |e|: how far the edges of positions f are from given edge vectors e.
///
/// The norms use |w|, because w is negative opposite large angles and then defines no norm.
/// \param weights w, `cotan_weights()` of the surface, |E|
/// \param f 3 x |V| \param edges |E| x 3, not all zero
double closure_residual(const Surface_ref& surface, const Eigen::VectorXd& weights, const Points& f,
                        const Eigen::MatrixX3d& edges, const Surface_part& part = {});

/// \brief the change of `transformed_edges()` with lambda, |E| x 3: they are quadratic in it.
Eigen::MatrixX3d edge_change(const Surface_ref& surface, const Quaternion_vector<double>& lambda,
                             const Quaternion_vector<double>& dlambda);

/// \brief columns V such that the gradient of the sum of a_k <y, e~_k> over the edges is V y, for
/// imaginary y: |V| x m, for each column of a.
/// \param a |E| x m
Block<Quaternion<double>> edge_gradients(const Surface_ref& surface,
                                         const Quaternion_vector<double>& lambda,
                                         const Eigen::MatrixXd& a);

/// \brief the transpose: the gradient q of the sum of <y_k, e~_k> over the edges, |V|: its change
/// is Re <q, dlambda>.
/// \param y |E| x 3
Quaternion_vector<double> edge_gradient(const Surface_ref& surface,
                                        const Quaternion_vector<double>& lambda,
                                        const Eigen::MatrixX3d& y);

}  // namespace internal

/// \ingroup PkgSpin
/// \brief the rho on faces that minimises (D - rho) mu in each face: Re(conjugate(B mu) D mu) / |B
/// mu|^2 [CGP 6.3]; in 1/length. Zero where the mean B mu of a face vanishes,
/// or its area is below a millionth of the mean one.
///
/// If mu solves a Dirac equation, the result is rho + gamma of that equation.
/// \param mu |V|
Curvature_potential curvature_of_spins(const Surface_ref& surface,
                                       const Quaternion_vector<double>& mu);

/// \ingroup PkgSpin
/// \brief finds the vertex positions whose edge vectors fit prescribed ones best [CGP (5.5)].
///
/// Given one vector e_ij per edge i -> j, minimises sum_ij w_ij |f_j - f_i - e_ij|^2 over the
/// positions f, where w are the cotan weights of the mesh. The minimiser solves L f = d0^T w e with
/// the positive semidefinite cotan Laplacian L; the sum is convex even if weights are negative.
///
/// L depends only on the mesh. The constructor factors it, and `update_geometry()` again after the
/// mesh has moved; each call costs two triangular solves with three right-hand sides.
///
class Poisson_reconstruction {
 public:
  /// \param surface must outlive the object
  /// \param pattern `vertex_graph(surface)`
  /// \pre `require_surface()` of the mesh holds
  /// \throw Solver_error if the Laplacian cannot be factored
  Poisson_reconstruction(const Surface_ref& surface, std::shared_ptr<const Sparse_pattern> pattern,
                         const Spin_solvers& solvers = {});

  /// shares the symbolic analysis of another solver with the same pattern
  /// \param other a `Solver` of the same traits, for any scalar
  template <class Scalar>
  Poisson_reconstruction(const Surface_ref& surface, std::shared_ptr<const Sparse_pattern> pattern,
                         const internal::Solver_ref<Scalar>& other)
      : m_surface(surface), m_L(pattern), m_solver(std::move(pattern), other)
  {
    update_geometry();
  }

  /// \brief adopts new positions of the mesh: assembles the Laplacian and factors it with the same
  /// symbolic analysis.
  /// \throw Solver_error if the Laplacian cannot be factored
  void update_geometry();

  /// the solver for the Laplacian
  const internal::Grounded_solver& solver() const { return m_solver; }

  /// returns f, 3 x |V|: the unique minimiser with mean zero
  /// \param edges |E| x 3, edge k runs from `surface.ends(k)[0]` to `surface.ends(k)[1]`
  Points positions(const Eigen::MatrixX3d& edges) const;

  /// \brief the transpose of `positions()`: w d0 L^-1 y, |E| x k, for gradients y of functions of
  /// coordinates, |V| x k.
  Eigen::MatrixXd edge_gradient(const Eigen::MatrixXd& y) const;

  /// \brief the `internal::closure_residual()` of positions f and edge vectors e, 3 x |V| and |E| x
  /// 3: zero if and only if the edge vectors close up around every face and are those of f.
  double residual(const Points& f, const Eigen::MatrixX3d& edges) const;

  Solver_statistics statistics() const { return m_solver.statistics(); }

 private:
  Surface_ref m_surface;
  Eigen::VectorXd m_weights;  // |E|
  Hermitian_sparse_matrix<double> m_L;
  internal::Grounded_solver m_solver;
};

}  // namespace Conformal_geometry_processing
