// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_PRESCRIBED_POSITIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_PRESCRIBED_POSITIONS_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Dirichlet_solver.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>
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
/// \tparam Problem a `Dirac_eigenproblem` of the same traits
template <class SolverTraits, class Problem>
class Prescribed_positions {
 public:
  /// \param problem must outlive the object
  /// \param condition of kind `positions`
  /// \throw Precondition_error if the normals of the curve turn once too often against those of
  /// the surface: no continuous lambda does that (they are of different spin structures); if the
  /// curve folds back at a vertex, or has its normal along it
  Prescribed_positions(Problem& problem, const Boundary_condition& condition,
                       const std::string& function);

  /// \param[in,out] s lambda and the evidence for it are filled in
  void solve(const Curvature_potential& rho, Dirac_solution& s);

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

  /// of the linear system inside, relative to what the boundary contributes
  double residual(const Quaternion_vector<double>& lambda) const;

  Problem& m_problem;
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
