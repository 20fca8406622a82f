// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Dirac_line.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Linear_constraints.h>
#include <Conformal_geometry_processing/spin/Potential_metric.h>
#include <Conformal_geometry_processing/spin/Spin_derivative.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief searches the change rho' of curvature nearest to a given rho whose transformation does
/// what residuals ask for: minimises
///
///     <rho' - rho, K (rho' - rho)> + sum of r_k(lambda)^2    with c_k(lambda) = 0
///
/// by the method of Gauss and Newton with exact derivatives (`Spin_derivative`), from rho' = 0. K
/// is a `Potential_metric`, so that rho' - rho is smooth; for rho = 0, rho' is.
///
/// A step minimises the sum with r linearised, S its derivative, by conjugate gradients for
/// K + S^T S preconditioned by K, among the changes that satisfy the linearised constraints. Limbs
/// make lambda so sensitive to rho that it soon leaves the curved valley of small residuals. On
/// closed surfaces without constraints, to which whole steps converge quadratically, a step is made
/// as long as the spins that a `Dirac_line` predicts ask for. It is shortened until it does reduce
/// the sum, if need be with a second step from there, which returns to the valley. Each evaluation
/// corrects the predicted spins, mostly at the cost of one factorization; a step takes 20 to 100
/// solves with this factor. Without constraints, products with S^T S take two of them: the factor
/// is so near to X - mu M_V that it may stand for it. Gradients, and the spins that a step leads
/// to, are exact.
class Potential_search {
 public:
  /// a rho' with its spins, residuals and constraints
  struct Candidate {
    Curvature_potential rho;  // in 1/length of the system
    Dirac_solution solution;
    Eigen::VectorXd residuals, constraints;
    double sum = 0;
  };

  /// \param system of the surface; its matrix and factor are overwritten
  /// \param rho in 1/length of the system
  /// \param residuals, constraints must outlive the object
  /// \param smoothness s of K in squares of the radius of the sphere of the same area: changes
  /// that vary over less than sqrt(s) radii are avoided
  Potential_search(Dirac_system& system, Curvature_potential rho,
                   std::vector<Spin_residual*> residuals,
                   std::vector<Spin_residual*> constraints = {}, double smoothness = 0.1);

  /// \brief continues from the present rho' until a step would make the sum smaller by less than
  /// 1 %, or two in turn have by less than 2 % each, and the norm of the constraints is at most
  /// `tolerance`.
  ///
  /// The residuals may have changed since the last call.
  /// \returns whether that was reached; otherwise the present rho' is the best one found
  /// \throw Solver_error if a factorization fails
  bool minimize(const Dirac_options& options, const Go_further& go_further, double tolerance);

  /// \brief satisfies constraints that have changed a little, with the gradients of the last step
  /// of `minimize()`, one factorization and few solves each.
  ///
  /// Each step has to reduce the norm of the constraints to a tenth: the gradients then still hold
  /// to about that share, and the sum is minimal to its square, the 1 % of `minimize()`.
  /// \returns whether their norm is at most `tolerance`; otherwise all is as it was. False if there
  /// was no step, if the constraints were more or fewer then, or if there are residuals, whose
  /// minimum also moves
  /// \throw Solver_error if a factorization fails
  bool follow_constraints(const Dirac_options& options, const Go_further& go_further,
                          double tolerance);

  /// \brief goes to another rho', near to the present one, with spins that follow from its own.
  /// \returns whether they were found; otherwise all is as it was
  /// \throw Solver_error if a factorization fails
  bool move_to(const Curvature_potential& rho, const Dirac_options& options,
               const Go_further& go_further);

  /// the present rho'
  const Candidate& present() const { return m_now; }

  /// goes back to a rho' found before
  void restore(Candidate candidate)
  {
    m_now = std::move(candidate);
    m_factored_at = -1;
  }

  /// starts again from rho' = 0, for another rho
  void restart(Curvature_potential rho);

  /// \brief what evaluations and steps have cost, and whether they were cancelled
  const Dirac_solution& costs() const { return m_costs; }

  /// starts to count again
  void reset_costs() { m_costs = Dirac_solution(); }

 private:
  using Spins = Quaternion_vector<double>;
  using Derivative = Spin_derivative;

  /// a change of rho', and of its solution to first order
  struct Step {
    Eigen::VectorXd change;
    Spins lambda;
    double gamma = 0;
    bool is_improvement = false;  // not only a correction of the constraints
  };

  /// \param guess predicted solution
  Candidate evaluate(Eigen::VectorXd rho, const Dirac_solution& guess, const Dirac_options& options,
                     const Go_further& go_further);

  /// adopts the spins of a candidate for the residuals, and their values for it
  void measure(Candidate& c) const;

  /// the present rho' with residuals that may have changed, and with its factor
  void refresh(const Dirac_options& options, const Go_further& go_further);

  /// from the present rho', which was evaluated last; none if there is no derivative
  std::optional<Step> best_step();
  Step best_step(const Derivative& S);

  /// the derivative at the present rho', which was evaluated last
  Derivative derivative() const;

  /// what to add to a step that corrects the constraints, so that it minimises the sum; empty if
  /// the sum would become less smaller than 1 %
  Eigen::VectorXd improvement(const Derivative& S, const Linear_constraints& constraints,
                              const Eigen::VectorXd& g, const Eigen::VectorXd& first) const;

  /// \brief adds to a step the changes of spins and eigenvalue at the present rho', which was
  /// evaluated last.
  /// \returns false if there is no derivative
  bool predict(Step& step);

  /// spins that are expected, and how much those that are found have to overlap with them
  struct Prediction {
    Dirac_solution solution;
    double least_overlap;
  };

  /// after t times the step, to first order
  Prediction predicted(const Step& step, double t) const;

  /// after t times the step, on the line along it if there is one
  std::optional<Prediction> predicted(const Step& step, double t,
                                      const std::optional<Dirac_line>& line) const;

  /// \brief the present rho' plus t times the step; with spins that depart from the predicted ones,
  /// it counts as not converged.
  Candidate moved(const Step& step, double t, const Prediction& predicted,
                  const Dirac_options& options, const Go_further& go_further);

  /// the whole step, with spins predicted by the derivative
  Candidate moved(const Step& step, const Dirac_options& options, const Go_further& go_further)
  {
    return moved(step, 1, predicted(step, 1), options, go_further);
  }

  /// \pre a step from the present rho', whose factor is at hand
  Dirac_line line_along(const Step& step);

  /// \brief the t = 1, 1/2, ... for which the merit of the predicted spins is least; `shortest` if
  /// none is less than that of the present rho'.
  double best_length(const Step& step, const Dirac_line& line) const;

  /// makes the step, or a part of it
  /// \returns whether there is one that reduces the merit
  bool take(const Step& step, const Dirac_options& options, const Go_further& go_further);

  /// half of the gradient of the sum
  Eigen::VectorXd gradient(const Derivative& S) const;

  /// (K + S^T S) d; without constraints, with the factor at hand in S
  Eigen::VectorXd curvature(const Derivative& S, const Eigen::VectorXd& d) const;

  static constexpr double least_gain = 1e-2;   // of the sum by a step
  static constexpr double shortest = 1. / 64;  // of the lengths of steps that are tried

  double merit(const Candidate& c) const { return c.sum + m_penalty * c.constraints.norm(); }

  Dirac_system& m_system;
  Curvature_potential m_rho;
  std::vector<Spin_residual*> m_residuals, m_constraints;
  Potential_metric m_metric;
  Candidate m_now;
  int m_factored_at = -1;  // `changes()` of the system when it was that of m_now
  std::optional<Linear_constraints> m_last_constraints;  // of the last step
  double m_penalty = 0, m_last_length = 1;
  Dirac_solution m_costs;  // without spins
};

}  // namespace Conformal_geometry_processing::internal
