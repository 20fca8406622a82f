// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the derivative of the spins lambda of a transformation with respect to rho, and its
/// transpose.
///
/// lambda is the smallest eigenvector of X(rho + gamma) with respect to M_V, mu its eigenvalue, and
/// gamma is such that lambda is stationary for the signed form: <lambda, H lambda> = 0, with H from
/// `apply_dirac_form()`. For a change d of rho, and the change d' = d + d gamma of rho + gamma,
///
///     (X - mu M_V) dlambda = -dX(d') lambda,    2 Re <H lambda, dlambda> = <lambda, dH(d')
///     lambda>,
///
/// where dlambda is orthogonal to lambda, which is a choice of the gauge. The matrix is that of the
/// discrete problem, so the derivative is exact up to `tolerance`. With prescribed directions at
/// the boundary there is no gamma, and with a free boundary lambda solves (X + W) lambda = W 1 with
/// the weights W of `nearness_weight()`.
///
/// Each product costs a few solves with the factor at hand, usually two at a tolerance of 1e-4, and
/// as many products with X.
class Spin_derivative {
 public:
  using Vectors = Block<Quaternion<double>>;

  /// \param system must outlive the object and keep its matrix and its factor
  /// \param potential rho + gamma in 1/length of the system, or rho if gamma is not part of it
  /// \param lambda |V|
  /// \param tolerance relative error of products, in the energy norm
  /// \pre `solve_dirac_equation()` has just found lambda; no positions are prescribed
  /// \throw Solver_error if the iterations do not converge
  Spin_derivative(const Dirac_system& system, Curvature_potential potential,
                  Quaternion_vector<double> lambda, double tolerance = 1e-6);

  /// scaled to norm 1
  const Quaternion_vector<double>& lambda() const { return m_lambda; }

  /// with the factor so far, one right-hand side each
  int number_of_solves() const { return m_solves; }

  /// \brief dlambda, |V| x k, for k changes of rho.
  /// \param changes |V| or |F| x k, in 1/length
  /// \throw Solver_error if the iterations do not converge
  Vectors apply(const Eigen::MatrixXd& changes) const;

  /// dgamma for k changes of rho, 0 without a gamma
  Eigen::RowVectorXd gamma_change(const Eigen::MatrixXd& changes) const;

  /// \brief the gradients, |V| or |F| x k, of Re <q, lambda> for k columns q, |V| x k.
  ///
  /// q must not depend on the gauge: <lambda, q> = 0; that part is ignored.
  /// \throw Solver_error if the iterations do not converge
  Eigen::MatrixXd apply_transpose(const Vectors& q) const;

 private:
  /// without the part of gamma
  Vectors apply_at_fixed_gamma(const Eigen::MatrixXd& changes) const;
  Eigen::MatrixXd apply_transpose_at_fixed_gamma(const Vectors& q) const;

  /// (X - mu M_V)^+ b, or (X + W)^-1 b
  Vectors solve(Vectors b) const;
  void apply_matrix(const Vectors& x, Vectors& y) const;

  /// subtracts M_V lambda <lambda, v> or, for vectors and not forms, lambda <lambda, M_V v>
  void remove_gauge(Vectors& v, bool is_form) const;

  bool is_eigenvector() const { return m_system.is_closed() || m_system.directions(); }

  const Dirac_system& m_system;
  Curvature_potential m_potential;
  Quaternion_vector<double> m_lambda;  // of norm 1
  double m_length;                     // of lambda
  double m_tolerance;
  Eigen::VectorXd m_diagonal;        // -mu M_V, or W
  Eigen::VectorXd m_gamma_gradient;  // of -<lambda, H lambda>; empty without gamma
  mutable int m_solves = 0;
};

}  // namespace Conformal_geometry_processing::internal
