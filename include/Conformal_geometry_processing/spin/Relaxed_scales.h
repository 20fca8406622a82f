// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Relaxed_spins.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Scale_residual.h>
#include <Conformal_geometry_processing/spin/Spin_visitor.h>

#include <Eigen/Core>

#include <functional>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the `Relaxed_spins` of rho with a `Scale_residual` of the least weight w with which
/// lengths keep to the bound of a `Scale_control`.
///
/// rho is asked for in three parts, from lambda = 1, with one step for each; then w is changed
/// from step to step until lengths are just within the bound and steps are short, or
/// w is so small that it has no effect.
class Relaxed_scales {
 public:
  struct Options {
    Relaxed_spins::Options spins;
    int stages = 3;
    int max_steps = 16;
    double first_weight = 1;     ///< in 1 / R^2
    double least_weight = 0.01;  ///< has no effect
    double closeness = 0.012;    ///< of the largest log factor to that of the bound, relative
    double settled = 0.03;       ///< change of lambda, relative
    double last_tolerance = .1;  ///< of conjugate gradients, with all of rho
  };

  enum class End { within_bound, bound_is_slack, no_descent, too_many_steps };

  /// called after each step
  using Watch = std::function<void(const Relaxed_scales&, const Relaxed_spins::Progress&)>;

  Relaxed_scales(Dirac_system& system, const Curvature_potential& rho, const Scale_control& control,
                 const Options& options);

  End run(const Watch& watch = {});

  const Relaxed_spins& spins() const { return m_spins; }
  double weight() const { return m_weight; }  ///< w, in 1 / R^2
  double excess() const { return m_excess; }  ///< see `Spin_report::Scales::excess()`
  int steps() const { return m_steps; }

 private:
  bool step(double share, const Watch& watch);
  void change_weight();

  Dirac_system& m_system;
  const Scale_control& m_control;
  Options m_options;
  Eigen::VectorXd m_rho;
  Scale_residual m_scales;
  Relaxed_spins m_spins;
  double m_weight, m_excess = 0;
  double m_last_level = 0;  // log of the excess, relative to what is aimed at
  double m_rate = -.5;      // d log excess / d log weight, as far as changes of w trust in it
  double m_moved = 0;
  int m_steps = 0;
};

}  // namespace Conformal_geometry_processing::internal
