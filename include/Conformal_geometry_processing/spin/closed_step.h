// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/linear_algebra/krylov/Eigensolver_result.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Period_limit.h>
#include <Conformal_geometry_processing/spin/Spin_result.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

class Spin_transformation;

namespace internal {

/// a transformation of a surface with handles or holes
struct Closed_step {
  Spin_result result;       ///< with its period defect
  Curvature_potential rho;  ///< realised, in 1/length
  Eigen::MatrixX3d edges;   ///< before they are made to close up; |E| x 3
};

/// \brief transforms a surface by the rho next to a given one with which its edges close up.
///
/// The constraints of `Exactness_constraints` are those of an infinitely small rho, so the periods
/// of a finite step are of second order. A quasi-Newton iteration removes them: the derivative of
/// the periods at rho = 0 gives the smallest change of rho that makes them vanish to first order,
/// and every change divides them by about ten. It stops at the limit, or when a change leaves more
/// than a quarter of the defect: the step is then too large, or its periods lie where no rho moves
/// them, as on isothermic surfaces, where one of the functions vanishes.
///
/// Where prescribed directions turn the boundary, lambda is far from 1, and the periods that come
/// from turning are of first order. The iteration is then Newton's, with the derivative at the
/// transformation found, and the change is the part of rho that has to be added for the surface to
/// close.
///
/// Costs one numeric factorization of the Dirac matrix for each change; two, and three solves for
/// each loop, where directions turn.
///
/// \param rho in 1/length, one number per vertex or per face
/// \param share of the way that the step makes, for the limit
/// \throw as `Spin_transformation::step()`
Closed_step closed_step(Spin_transformation& transformation, const Curvature_potential& rho,
                        const Period_limit& limit, double share, const Dirac_options& options,
                        const Go_further& go_further);

/// \ingroup PkgSpin
/// a single transformation, with its period defect
Closed_step measured_step(Spin_transformation& transformation, const Curvature_potential& rho,
                          const Dirac_options& options, const Go_further& go_further);

/// \ingroup PkgSpin
/// the derivative of the periods by rho in the unit of the surface, at a step, whose report counts
/// the costs
Eigen::MatrixXd period_derivative(Spin_transformation& transformation, Closed_step& step);

}  // namespace internal
}  // namespace Conformal_geometry_processing
