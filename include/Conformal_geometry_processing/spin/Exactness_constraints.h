// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/exactness_functions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Grounded_solver.h>
#include <Conformal_geometry_processing/spin/Constraint_basis.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

#include <optional>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgSpin
/// \brief the functions that rho must be orthogonal to on a surface with handles or holes so that
/// the edges of the transformed surface stay exact, that is close up around them, and the defect of
/// a transformation [CGP 4.5.2].
struct Exactness_constraints {
  Curvature_potential::On on = Curvature_potential::On::vertices;  ///< where the values of rho are
  Harmonic_basis forms;       ///< of the surface, with fields only where `Exactness::thesis` needs
                              ///< them; none on spheres and disks
  Eigen::VectorXd weights;    ///< `cotan_weights()`, |E|
  Eigen::VectorXd areas;      ///< `curvature_areas()`, |V| or |F|
  Eigen::MatrixXd functions;  ///< `exactness_functions()`, three for each form; |V| or |F| rows
  bool constants_have_effect = false;  ///< gamma is a misfit, not an eigenvalue up to which rho is
                                       ///< realised
  int factorizations = 0;              ///< of X, and
  int solves = 0;                      ///< with its factor, that were needed

  /// the basis of the functions and, if constants have no effect, of the constants
  Constraint_basis basis() const;

  /// \brief the norm of the harmonic part of new edge vectors, relative to their norm: zero if they
  /// close up around the handles; always zero on spheres and disks.
  /// \param edges |E| x 3, of a transformation of the surface
  double period_defect(const Eigen::MatrixX3d& edges) const;
};

}  // namespace internal

/// \ingroup PkgSpin
/// \brief computes the constraints of a surface.
///
/// Costs 4G solves with a Laplacian that is already factored, a factorization of the Dirac matrix
/// for rho = 0, and about 10G solves with it; nothing without generators.
///
/// \param system of the surface; its factor is overwritten
/// \param laplacian solves with the Laplacian of the surface
/// \param generators closed forms of the surface, one column for each loop around handles and holes
/// \param on where the values of rho are
/// \param version empty: no functions are computed. With a boundary, always the adjoint
/// \throw Solver_error if a factorization fails, or a solve
internal::Exactness_constraints exactness_constraints(internal::Dirac_system& system,
                                                      const internal::Grounded_solver& laplacian,
                                                      Eigen::MatrixXd generators,
                                                      Curvature_potential::On on,
                                                      std::optional<Exactness> version);

}  // namespace Conformal_geometry_processing
