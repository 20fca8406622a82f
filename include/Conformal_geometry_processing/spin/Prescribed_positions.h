// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_PRESCRIBED_POSITIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_PRESCRIBED_POSITIONS_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Dirichlet_solver.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief spins and positions of a surface whose boundary becomes a given curve with given normals
/// [CGP 6.3.2].
///
/// At the boundary lambda is known: it turns the frame of the surface into that of the curve and
/// stretches by the ratio of lengths. Inside it minimises |(D - rho) lambda|^2, a linear system.
/// The positions are those of (5.5), with the boundary where it has to be.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class SolverTraits>
class Prescribed_positions {
 public:
  /// \param surface must outlive the object
  /// \param condition of kind `positions`
  /// \param pattern `vertex_graph(surface)` \param solver one of the same traits whose analysis is
  /// shared
  /// \throw Precondition_error if the normals of the curve turn once too often against those of
  /// the surface: no continuous lambda does that (they are of different spin structures); if the
  /// curve folds back at a vertex, or has its normal along it
  template <class Solver>
  Prescribed_positions(const Surface_ref& surface, const Boundary_condition& condition,
                       std::shared_ptr<const Sparse_pattern> pattern, const Solver& solver,
                       const std::string& function)
      : m_surface(surface),
        m_frames(boundary_frames(surface)),
        m_targets(condition.targets),
        m_spins(spins(condition, function)),
        m_lambda(pattern, m_frames.vertices, solver),
        m_positions(std::move(pattern), m_frames.vertices, solver)
  {}

  /// \brief factors the part of X inside.
  /// \throw Solver_error if that fails
  void factorize(const Hermitian_sparse_matrix<Quaternion<double>>& X) { m_lambda.factorize(X); }

  /// \brief lambda, |V|: the values at the boundary, and the least energy inside
  /// \pre X has been factorized
  Quaternion_vector<double> spins(const Hermitian_sparse_matrix<Quaternion<double>>& X) const;

  /// of the linear system inside, relative to what the boundary contributes
  double residual(const Hermitian_sparse_matrix<Quaternion<double>>& X,
                  const Quaternion_vector<double>& lambda) const;

  /// the positions with edges as given as can be, and the boundary on the curve; 3 x |V|
  /// \throw Solver_error if the Laplacian cannot be factored
  Points positions(const Eigen::MatrixX3d& edges);

 private:
  std::vector<Quaternion<double>> spins(const Boundary_condition& condition,
                                        const std::string& function) const;

  /// \param first the place of the loop among all boundary vertices
  Quaternion<double> spin_at(const Boundary_condition& condition, std::size_t first,
                             const std::vector<int>& loop, std::size_t k,
                             const std::string& function) const;

  Surface_ref m_surface;
  Boundary_frames m_frames;
  Points m_targets;
  std::vector<Quaternion<double>> m_spins;
  Dirichlet_solver<Quaternion<double>, SolverTraits> m_lambda;
  Dirichlet_solver<double, SolverTraits> m_positions;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Prescribed_positions_templates.h>
#endif

#endif
