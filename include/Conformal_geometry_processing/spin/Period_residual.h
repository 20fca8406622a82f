// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Exactness_constraints.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <cmath>

namespace Conformal_geometry_processing::internal {

/// \brief the harmonic part of the transformed edges, three numbers for each loop around handles
/// and holes: its norm is `Exactness_constraints::period_defect()`, zero if the surface closes.
class Period_residual : public Spin_residual {
 public:
  /// of the square of the residual, at first: what it leaves, `Relaxed_spins::meet_few()` takes
  /// off, but not in the way that shears least
  static constexpr double default_weight = 1e5;

  /// \param exactness of the surface; both must outlive the object
  Period_residual(const Surface_ref& surface, const Exactness_constraints& exactness);

  void set_spins(const Spins& lambda) override;
  Eigen::VectorXd values() const override { return std::sqrt(m_weight) * m_values; }
  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;
  bool is_few() const override { return true; }
  Spin_columns columns() const override;  ///< one for each loop
  Eigen::Index most_one_by_one() const override { return 48; }

  /// \param b factor of the square of the residual
  void set_weight(double b) { m_weight = b; }

 private:
  Eigen::VectorXd periods(const Eigen::MatrixX3d& edges) const;

  /// the sums of the forms whose work on edges is that of c on the values, c being `size()` x k
  Eigen::MatrixXd edge_forces(const Eigen::MatrixXd& c) const;

  Surface_ref m_surface;
  const Exactness_constraints& m_exactness;
  Spins m_lambda;
  double m_weight = default_weight;
  double m_length = 1;  // of the edges
  Eigen::VectorXd m_values;
};

/// spins whose edges close up around handles and holes
struct Closed_spins {
  Quaternion_vector<double> lambda;  ///< |V|
  Eigen::VectorXd rho;               ///< whose equation they solve, |V|
  double period_defect = 0;          ///< that is left
  int solves = 0;
};

/// \brief changes spins that solve a Dirac equation, and rho, until the edges close up around
/// handles and holes.
///
/// The constraints of `Exactness_constraints` are those of an infinitely small rho, so the periods
/// of a finite step are of second order. The unknowns here are changes dl of lambda and d of rho
/// with X dl = -dX(d) lambda, that is (D - rho) dl = d lambda in the sense of least squares, and d
/// is the smallest one, in the norm of the areas, with which the `Period_residual` vanishes
/// to first order. A change of lambda alone would take as much off the periods, but open the edges
/// around vertices by as much.
///
/// Iterates with the derivative at the given spins. Stops at the limit, or when a change leaves
/// more than a quarter of the defect: the step is then too large, or no small rho moves its
/// periods, as on isothermic surfaces, where one of the functions vanishes.
///
/// Factorizes nothing, and costs one solve for each loop, three where directions are prescribed,
/// and one for each change.
/// \param system with the factor of X, or one nearby, as the solution of the equation leaves it
/// \param rho |V|, in 1/length of the system, with gamma where that is an eigenvalue
/// \param limit of the period defect
Closed_spins closed_spins(const Dirac_system& system, const Exactness_constraints& exactness,
                          Eigen::VectorXd rho, Quaternion_vector<double> lambda, double limit);

}  // namespace Conformal_geometry_processing::internal
