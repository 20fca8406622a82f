// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include <utility>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the constraints C^T d = c of a step d, with an inner product K.
///
/// Damped least squares: a constraint that steps meet by its damping times less than others would
/// take large ones, and is nearly left out, such as the period that does not change on an
/// isothermic surface.
class Linear_constraints {
 public:
  /// \param gradients C, one column for each constraint
  /// \param directions K^-1 C
  /// \param dampings of each constraint, see `Spin_residual::damping()`
  Linear_constraints(Eigen::MatrixXd gradients, Eigen::MatrixXd directions,
                     const Eigen::VectorXd& dampings);

  Eigen::Index size() const { return m_gradients.cols(); }  ///< how many

  /// the shortest d with C^T d = c, K^-1 C (C^T K^-1 C)^-1 c
  Eigen::VectorXd least_solution(const Eigen::VectorXd& c) const;

  /// \brief corrects what shortest solutions are made of: where the constraints changed by `change`
  /// after `least_solution(c)`, they would now be expected to (Broyden's update, the least in K).
  void observe(const Eigen::VectorXd& c, const Eigen::VectorXd& change);

  /// d without its part in the span of K^-1 C, orthogonally with respect to K
  Eigen::VectorXd project_out(Eigen::VectorXd d) const;

  /// the transpose: a gradient g without its part in the span of C, of which such d know nothing
  Eigen::VectorXd project_gradient(Eigen::VectorXd g) const;

 private:
  Eigen::MatrixXd m_gradients, m_directions;
  Eigen::LDLT<Eigen::MatrixXd> m_gram;  // G = C^T K^-1 C
  Eigen::MatrixXd m_change;             // of constraints by K^-1 C y: G with the damping, at first
  Eigen::PartialPivLU<Eigen::MatrixXd> m_lu;  // of it
};

}  // namespace Conformal_geometry_processing::internal
