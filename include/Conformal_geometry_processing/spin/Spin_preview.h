// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Constraint_basis.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Spin_result.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief approximate transformations of one surface for a rho that changes little from call to
/// call, as under a brush: a tenth of the time of `Spin_transformation::transform()`.
///
/// X(0) is factored once. For smooth rho, X(rho) differs from it by a compact operator, so that its
/// factor is a preconditioner whose quality does not depend on the mesh: from the last spins, at
/// most `max_solves` solves make the error of the spins 1e-3 for the rho of an edit. Neither the
/// branch is followed nor a bound on lengths kept; around handles and holes, rho is made closed to
/// first order [CGP 4.5.2].
class Spin_preview {
 public:
  static constexpr int max_solves = 10;      ///< of a call
  static constexpr double tolerance = 1e-3;  ///< of the error of the spins

  /// \brief factors X(0): one ordering, one analysis and one factorization.
  /// \param transformation of the surface, which must not move; outlives the object
  /// \throw Precondition_error if it has boundary data
  /// \throw Solver_error if the factorization fails
  explicit Spin_preview(Spin_transformation& transformation);

  /// forgets the last spins: the next call starts from 1
  void restart();

  /// \brief approximates the surface with curvature changed by rho, from the spins of the last
  /// call.
  /// \param rho in 1/length of the mesh
  /// \returns positions and certificate of the approximation; `converged` tells whether the spins
  /// have reached the tolerance
  /// \throw Precondition_error if rho has the wrong length or a value that is not finite
  Spin_result transform(const Curvature_potential& rho);

 private:
  using Vectors = Block<Quaternion<double>>;

  /// rho without the part that opens handles and holes or has no effect
  Curvature_potential admissible(const Curvature_potential& rho);

  /// the smallest eigenvector of X(rho + gamma) from the last one, on a closed surface
  void improve_eigenvector(const Curvature_potential& rho, Dirac_solution& s);
  void iterate(const Curvature_potential& rho, double accuracy, int solves, Dirac_solution& s);

  /// the spins nearest to 1, on a surface with a free boundary
  void improve_nearest(const Curvature_potential& rho, Dirac_solution& s);

  Spin_transformation& m_transformation;
  Dirac_system m_system;      // its factor is that of X(0)
  Eigen::VectorXd m_weights;  // of nearness to 1, |V|; with a boundary
  Quaternion_vector<double> m_lambda;
  double m_gamma = 0;  // of the admissible part of rho
};

}  // namespace Conformal_geometry_processing::internal
