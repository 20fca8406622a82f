// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \brief the derivative of `restore_area()`: changes df of positions without the scaling and the
/// translation that restoring area and centroid undoes, and the transpose.
///
/// With the area A, its gradient g, and the centroid c,
///
///     df -> df - (f - c) <g, df> / (2A) - dc.
class Placement_derivative {
 public:
  /// \param mesh whose faces are measured; must outlive the object
  /// \param f positions after `restore_area()`, 3 x |V|
  Placement_derivative(const Mesh_view& mesh, Points f);

  /// \param df 3 x |V|
  Points apply(const Points& df) const;

  /// \param y 3 x |V|: the gradient of a function of the placed positions
  Points apply_transpose(const Points& y) const;

 private:
  const Mesh_view& m_mesh;
  Points m_arms;              // f - c
  Points m_area_gradient;     // g
  Eigen::VectorXd m_areas;    // |F|, of f
  Eigen::Matrix3Xd m_middle;  // barycentres of the faces - c
  Points m_normals;           // 3 x |F|
};

/// \brief the derivative of the positions of a transformed surface with respect to the spins
/// lambda, and its transpose; all in the frame of the system.
///
/// Includes what `Spin_transformation` does to lambda and to the positions: `fix_gauge()` keeps the
/// mean of lambda real, `restore_area()` keeps area and centroid. A change of lambda by a right
/// factor therefore has no effect. Each product costs a solve with the Laplacian, three columns.
class Position_derivative {
 public:
  /// \param system and reconstruction of the surface; must outlive the object, as the mesh
  /// \param measured the faces on which `restore_area()` measures
  /// \param lambda spins of the result, after `restore_area()`, |V|
  /// \param f its positions, 3 x |V|
  Position_derivative(const Dirac_system& system, const Poisson_reconstruction& reconstruction,
                      const Mesh_view& measured, Quaternion_vector<double> lambda, Points f);

  /// df, 3 x |V|
  Points apply(Quaternion_vector<double> dlambda) const;

  /// the gradient q of a function of the positions whose gradient is y, 3 x |V|: its change is
  /// Re <q, dlambda>
  Quaternion_vector<double> apply_transpose(const Points& y) const;

 private:
  const Dirac_system& m_system;
  const Poisson_reconstruction& m_reconstruction;
  Quaternion_vector<double> m_lambda;
  double m_mean = 0;  // of lambda, integrated; 0 if the gauge is not fixed
  Placement_derivative m_placement;
};

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
};

}  // namespace Conformal_geometry_processing::internal
