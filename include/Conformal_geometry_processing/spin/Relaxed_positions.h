// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Control_point.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Position_residual.h>
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief the `Relaxed_scales` of rho with a `Position_residual`, and a `Period_residual` where
/// there are handles or holes: conformal surfaces whose control points are near to targets.
///
/// Where targets have to be met exactly, the weight of distances d is 16 (R / d)^2: far from the
/// targets it is small, since the first change of a surface may hardly move points (a round sphere
/// moves along its normals alone, and along itself once it is bumpy); near to them, where nothing
/// is left alone, it squares distances from step to step. What is left with the largest weight, a
/// few steps of Newton's method take off.
class Relaxed_positions {
 public:
  using Transformation = Spin_transformation;
  using State = Relaxed_scales::State;

  /// what there is besides targets
  struct Problem {
    std::vector<Control_point> points;
    Eigen::VectorXd masses;  ///< weights of the squares of distances, one per point; empty: 1
    Eigen::VectorXd rho;     ///< wanted, |V|, in 1/length of the frame
    Scale_control scales;
    /// of the sum of the squares of distances by R; infinity: they have to vanish
    double weight = std::numeric_limits<double>::infinity();
    std::size_t anchors = 0;  ///< so many of the last points are near to their targets, not there
  };

  /// \param transformation must outlive the object
  /// \param targets 3 x number of points, in the frame of the transformation
  Relaxed_positions(Transformation& transformation, Problem problem, const Points& targets,
                    const Relaxed_scales_options& options = {});
  Relaxed_positions(const Relaxed_positions&) = delete;
  Relaxed_positions& operator=(const Relaxed_positions&) = delete;

  const std::vector<Control_point>& points() const { return m_problem.points; }

  /// \param targets 3 x number of points, in the frame of the transformation
  void set_targets(const Points& targets);

  /// \brief lets anchors go farther, for what cannot be reached otherwise.
  /// \returns false if they hardly hold anything any more
  bool loosen();

  /// \param weight see `Problem::weight`
  void set_weight(double weight);

  /// \brief goes on from the present spins; at first, these are the start of `Relaxed_spins`.
  /// \throw Solver_error if a factorization fails
  Relaxed_scales::End go_on(const Go_further& go_further);

  State state() const { return m_scales.state(); }
  void restart(const State& state) { m_scales.restart(state); }

  /// whether distances have to vanish, and do
  bool is_met();

  /// the root of the sum of the squares of distances times masses, by R
  double distance();

  /// the control points on the present surface
  Points present_points() const;

  /// \brief the present surface, with its report and all costs since `reset_costs()`; without
  /// positions if the search was cancelled
  Spin_result present();
  void reset_costs() { m_scales.reset_costs(); }
  void renew_budget() { m_scales.renew_budget(); }

  const Relaxed_scales& scales() const { return m_scales; }

 private:
  bool is_exact() const { return m_problem.weight == std::numeric_limits<double>::infinity(); }
  Spin_residuals residuals();
  Eigen::VectorXd anchor_masses() const;
  Relaxed_scales_options completed(Relaxed_scales_options options);

  /// adapts the weights of what has to vanish
  /// \returns whether it does
  bool adapt();

  Transformation& m_transformation;
  Problem m_problem;
  Position_residual m_positions;               // of the points without anchors
  std::optional<Position_residual> m_anchors;  // of all points, if there are anchors
  std::optional<Period_residual> m_periods;
  double m_weight = 1, m_hold = 1e6;
  Relaxed_scales m_scales;
};

}  // namespace Conformal_geometry_processing::internal
