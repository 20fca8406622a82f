// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Spin_gauge.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// what a minimisation over spins has cost
struct Relaxed_costs {
  int factorizations = 0, solves = 0;                ///< quaternionic
  int block_columns = 0;                             ///< solved for the few residuals
  int scalar_factorizations = 0, scalar_solves = 0;  ///< of H
  Dirac_evidence::Seconds seconds;
};

/// \brief approximates the inverse of the Hessian of `Relaxed_spins` for changes of lambda, by that
/// of w X(rho') + the stiffness of residuals + G G^T, w the sum of the weights of the misfit and G
/// the gradients of the residuals that are few: one solve with the factor of the first two for each
/// of their `Spin_columns`, and for each application.
///
/// The factor and these solves are kept as long as lambda has moved little since and the stiffness
/// has not changed much. What a large weight of the few multiplies is up to date all the same: in
/// the span Y of the solves, the inverse is that of S = w X + G G^T with the present G, and where
/// it is orthogonal to Y by S, that of w X (balancing).
///
/// Where one of the few residuals has more than `Spin_residual::most_one_by_one()` values, all of
/// them are left to the iterations, which then have to go on for longer: their condition is that of
/// 1 + G^T (w X)^-1 G, some hundreds for many holes.
class Spin_preconditioner {
 public:
  using Spins = Quaternion_vector<double>;
  using Vectors = Block<Quaternion<double>>;

  /// \param system its factor is replaced; it and the residuals must outlive the object
  /// \param reuse the factor is kept while lambda has moved by less, in the mean
  Spin_preconditioner(Dirac_system& system, const Spin_residuals& residuals, double weight,
                      double reuse);

  /// \param weight w from now on
  void set_weight(double weight) { m_weight = weight, forget(); }

  /// with what another object makes the same factor
  struct Origin {
    Eigen::VectorXd rho, shift;  ///< |V|, rho' and the diagonal that was added to X
    double moved = 0;            ///< how far lambda has moved since
  };

  Origin origin() const { return {m_factored_rho, m_factored_shift, m_moved}; }

  /// \throw Solver_error if the factorization fails
  void factorize_at(const Origin& origin, Relaxed_costs& costs);

  /// adds to how far lambda has moved since the factor
  void moved(double distance) { m_moved += distance; }

  /// the factor belongs to spins far away
  void forget() { m_moved = m_reuse; }

  /// \brief adopts lambda and rho', at which the residuals are.
  /// \throw Solver_error if the factorization fails
  void update(const Spins& lambda, const Eigen::VectorXd& rho, Relaxed_costs& costs);

  /// of gradients, to changes in the gauge of lambda
  Vectors apply(const Vectors& g, Relaxed_costs& costs) const;

  /// \brief the sum of `Spin_residual::gradient()` of `change()` over all residuals, for a change
  /// in the gauge of lambda: of the few by their columns.
  Spins residual_product(const Spins& y) const;

  bool has_few() const { return !m_few.empty(); }  ///< residuals

  /// whether the few residuals are too many for this, and left to the iterations
  bool leaves_few() const;

  /// \brief the change of lambda that takes off so much of the values of the few residuals, at the
  /// least cost of others.
  /// \pre there are such residuals
  Spins correction(const Eigen::VectorXd& values, Relaxed_costs& costs) const;

 private:
  /// \returns whether there is a new factor
  bool factorize(const Eigen::VectorXd& rho, Relaxed_costs& costs);
  Vectors solve(const Vectors& g) const;
  Spin_columns gradient_columns() const;  // of G, in the gauge of lambda
  void choose_few(const Spin_columns& few, Relaxed_costs& costs);
  void adopt_few();
  Spins iterated_correction(const Eigen::VectorXd& values, Relaxed_costs& costs) const;

  Dirac_system& m_system;
  Spin_gauge m_gauge;
  Spin_residuals m_dense, m_few;
  double m_weight, m_reuse;
  Eigen::VectorXd m_factored_rho, m_factored_shift;
  double m_moved = 0;
  double m_factored_stiffness = -1;
  int m_factored_changes = -1;
  Spins m_lambda;
  double m_chosen_at = 0;                  // how far lambda had moved
  Vectors m_gradients;                     // G, in the gauge of lambda
  Vectors m_few_changes, m_few_forces;     // Y with <Y, w X Y> = 1, and w X Y
  Vectors m_images;                        // S Y
  Eigen::MatrixXd m_few_products;          // G^T Y
  Eigen::LDLT<Eigen::MatrixXd> m_inverse;  // of <Y, S Y>
};

}  // namespace Conformal_geometry_processing::internal
