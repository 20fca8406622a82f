// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Dirac_solution.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Relaxed_spins.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <optional>

namespace Conformal_geometry_processing::internal {

struct Relaxed_scales_options {
  Relaxed_spins::Options spins;
  int stages = 3;
  int max_steps = 16;
  /// of conjugate gradients, in all searches since `renew_budget()`: beyond, they end with what
  /// they have. Some twenty times those of most results.
  int max_iterations = 1000;
  double least_weight = 0.01;  ///< w in 1 / R^2 that has no effect
  double closeness = 0.007;    ///< of the largest log factor to that of the bound, relative
  double settled = 0.1;        ///< change of lambda by a step, relative to all of its way
  double least_gain = 0.02;    ///< of a step, relative to the sum of the terms
  double last_tolerance = .2;  ///< of conjugate gradients, with all of rho
  /// asked after each step, and may change weights of other residuals: whether these are met, as
  /// far as they have to be
  std::function<bool()> is_met = [] { return true; };
  std::function<void()> between_steps = [] {};  ///< may ask for `Relaxed_scales::position()`
};

/// \brief the `Relaxed_spins` of rho with a `Scale_residual` of the least weight w with which
/// lengths keep to the bound of a `Scale_control`, if it has one.
///
/// rho, and what other residuals ask for, is asked for in three parts, with one step for each. From
/// the last of them on, log w is an unknown of each step: lengths are just within the bound where
/// the step leads, to first order; until steps are short, or w is so small that it has no effect.
/// What is wide against the limbs *is* scale, and is reduced;
/// what is narrow survives.
class Relaxed_scales {
 public:
  enum class End { within_bound, settled, no_descent, too_many_steps, cancelled };

  /// asks other residuals for a share of the way
  using Ask = std::function<void(double share)>;

  /// where the steps are
  struct State {
    Quaternion_vector<double> lambda;
    Eigen::VectorXd rho;  // rho'
    double weight, excess;
  };

  /// \brief where a search is between two steps, with all that the next ones depend on but its
  /// problem and the weights of the misfit: from there, another object takes the same ones.
  struct Position {
    State state;
    std::optional<State> best;      // within the bound
    Relaxed_spins::Spins response;  // to log w, or empty
    Spin_preconditioner::Origin factored;
    double way, room;
    int steps, spent;
  };

  /// \param rho wanted, |V|, in 1/length of the system
  /// \param others further residuals; they, system and control must outlive the object
  Relaxed_scales(Dirac_system& system, const Eigen::VectorXd& rho, const Scale_control& control,
                 Spin_residuals others = {}, const Relaxed_scales_options& options = {});

  /// \brief goes all of the way, from the spins at the start.
  /// \param go_further called after each iteration, with the change of lambda in the last step as
  /// the estimate
  ///
  /// \throw Solver_error if a factorization fails
  End run(const Go_further& go_further = Always_go_further(), const Ask& ask = {});

  /// \brief goes on from the present spins, as after residuals have changed a little.
  /// \throw as `run()`
  End go_on(const Go_further& go_further = Always_go_further());

  Position position() const;

  /// \brief goes on from another object's position.
  /// \param factor by which it had multiplied the weights of the misfit
  /// \throw as `run()`
  End resume(const Position& position, double factor, const Go_further& go_further);

  /// \brief likewise for another rho that is near.
  End follow(const Eigen::VectorXd& rho, const Go_further& go_further = Always_go_further());

  /// \brief likewise with larger weights of the misfit, for edges that close up better.
  End stiffen(double factor, const Go_further& go_further = Always_go_further());

  /// from now on lengths stay so far below the bound, in units of `excess()`: room for what
  /// `meet_few()` adds
  void leave_room(double room) { m_room = (std::max)(m_room, room); }

  /// see `Relaxed_spins::meet_few()`
  void meet_few(bool is_anew);

  /// the present state
  State state() const { return {m_spins.lambda(), m_spins.rho(), m_weight, m_excess}; }

  /// goes on from another state, which may be that of other residuals
  void restart(const State& state);

  /// the solution, which is not an eigenvector, and its costs since the object exists, or
  /// `reset_costs()`
  Dirac_solution solution() const;

  /// the factors of lengths, and what is kept of rho
  Spin_report::Scales scales() const;

  /// counts costs from here on
  void reset_costs() { m_spins.reset_costs(), m_iterations = 0; }

  /// allows all iterations again, as for an edit after the last one
  void renew_budget() { m_spent = 0; }

  /// whether there is no iteration left
  bool is_spent() const { return m_spent >= m_options.max_iterations; }

  const Relaxed_spins& spins() const { return m_spins; }
  double weight() const { return m_weight; }  ///< w, in 1 / R^2; 0 without a bound
  double excess() const { return m_excess; }  ///< see `Spin_report::Scales::excess()`
  int steps() const { return m_steps; }

 private:
  End step(double share, const Go_further& go_further, const Relaxed_spins::Unknown& unknown = {});
  End go_up(const Go_further& go_further, const Ask& ask);
  End settle(const Go_further& go_further);
  void guess_weight(double share);
  void set_weight(double weight);
  Relaxed_spins::Unknown log_weight();
  double place_weight(const Relaxed_spins::Spins& there, const Relaxed_spins::Spins& response);
  double excess_of(const Relaxed_spins::Spins& lambda) const;
  void keep_if_within();
  void take_best();
  bool is_bounded() const { return m_control.bound.has_value(); }

  Dirac_system& m_system;
  const Scale_control& m_control;
  Relaxed_scales_options m_options;
  Eigen::VectorXd m_rho;
  Scale_residual m_scales;
  Relaxed_spins m_spins;
  End m_end = End::settled;
  std::optional<State> m_best;  // the last one within the bound
  double m_weight = 0, m_excess = 0, m_room = 0;
  Relaxed_spins::Spins m_response;            // of the spins to log w, or empty
  double m_moved = 0, m_way = 0, m_gain = 0;  // of lambda in the last step and all, of the sum
  int m_steps = 0, m_iterations = 0, m_spent = 0;
};

}  // namespace Conformal_geometry_processing::internal
