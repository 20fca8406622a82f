// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Control_point.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>
#include <Eigen/QR>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \brief the best similarity from points to targets, both in a frame of unit size: of those that
/// fit equally well (one point, two, a line of them), that which turns and scales least.
/// \param masses weights of the squares of distances, of the order of one together; all one if
/// empty
Alignment placement(const Points& points, const Points& targets,
                    const Eigen::VectorXd& masses = {});

/// \brief what similarities cannot change: an orthonormal basis Z of the motions of points that are
/// orthogonal to translations, turns and scaling, 3k x (3k - 7), with more columns if the points
/// are on a line.
///
/// A motion v is given as the roots of the masses times v.
class Shape_motions {
 public:
  Shape_motions() = default;

  /// \param points 3 x k, \param masses k
  Shape_motions(const Points& points, const Eigen::VectorXd& masses);

  /// 3k less the dimension of the motions of the points by similarities
  Eigen::Index size() const { return m_qr.rows() - m_qr.rank(); }

  /// Z^T v, its last `size` components
  /// \param v 3k
  Eigen::VectorXd coordinates(const Eigen::VectorXd& v, Eigen::Index size) const;

  /// Z y, the transpose
  Eigen::VectorXd motion(const Eigen::VectorXd& y) const;

 private:
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> m_qr;  // of the motions by similarities, 3k x 7
};

/// \brief the distances of control points of a transformed surface from their targets, after the
/// best similarity T, in units of the radius R of the sphere of the same area.
///
/// The values are Z^T m^(1/2) (T h - t) / R with h the control points, m their masses, and Z the
/// `Shape_motions` of T h. The change of T is orthogonal to Z, so the change of the values is Z^T
/// m^(1/2) dT(dh) / R, up to the change of Z, which is multiplied by distances that become small.
/// The similarity may be anything: the total scale, the position, and the turn of the surface have
/// no effect.
class Position_residual : public Spin_residual {
 public:
  /// \param surface, reconstruction must outlive the object
  /// \param masses weights of the squares of distances, one per point; all one if empty
  /// \param has_to_vanish whether few values are taken off altogether
  Position_residual(const Surface_ref& surface, const Poisson_reconstruction& reconstruction,
                    std::vector<Control_point> points, Eigen::VectorXd masses = {},
                    bool has_to_vanish = true);

  /// \param targets 3 x number of points, in the frame
  void set_targets(Points targets);

  /// \param masses one per point
  void set_masses(Eigen::VectorXd masses) { m_masses = std::move(masses); }

  /// \param w the values are multiplied by its root
  void set_weight(double w) { m_weight = w; }

  void set_spins(const Spins& lambda) override;
  Eigen::VectorXd values() const override { return coordinates(m_distances); }

  /// the points of the surface with these spins, before the similarity; up to a translation
  Points points_at(const Spins& lambda) const;

  Eigen::VectorXd change(const Spins& dlambda) const override;
  Spins gradient(const Eigen::VectorXd& y) const override;

  /// Of all vertices: the geometric mean of what the distances weigh, w / (pi k^2) at the wave
  /// number k and so least for waves, and of the misfit, c k^2, in units of R; c as told by
  /// `set_stiffness()`
  Eigen::VectorXd stiffness() const override;

  /// Of a few points, for which the constructor solves one Poisson equation each, and keeps |E|
  /// numbers each
  bool is_few() const override { return m_points.size() <= most_few; }
  Spin_columns columns() const override;
  bool has_to_vanish() const override { return is_few() && m_has_to_vanish; }

  /// \param c weight of what else keeps spins from varying, as that of a `Dirac_misfit`
  void set_stiffness(double c) { m_stiffness = c; }

  /// the root of the sum of the squares of distances times masses, in R
  double distance() const { return values().norm() / std::sqrt(m_weight); }

 private:
  static constexpr std::size_t most_few = 64;

  /// Z^T of the roots of masses and weight times v / R
  Eigen::VectorXd coordinates(const Points& v) const;

  /// the forces on points before the similarity whose work is that of y on the values
  Points forces(const Eigen::VectorXd& y) const;

  /// the points of the surface with these edge vectors, |E| x 3
  Points points_of(const Eigen::MatrixX3d& edges) const;

  /// the transpose
  /// \param forces 3 x number of points
  Eigen::MatrixX3d edge_forces(const Points& forces) const;

  Surface_ref m_surface;
  const Poisson_reconstruction& m_reconstruction;
  std::vector<Control_point> m_points;
  Eigen::VectorXd m_masses, m_areas;  // of points; of vertices
  double m_radius;                    // R
  bool m_has_to_vanish;
  Points m_targets;
  Eigen::Index m_size = 0;
  double m_weight = 1, m_stiffness = 0;
  Spins m_lambda;
  Eigen::MatrixXd m_influences;  // of edges on few points: no product then solves anything
  Alignment m_placement;         // T
  Points m_distances;            // T h - t
  Shape_motions m_motions;
};

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

  /// the control points on the present surface, up to a translation
  Points present_points() const;

  /// \brief the present surface, with its report and all costs since `reset_costs()`; without
  /// positions if the search was cancelled
  /// \param place moves it before it is judged
  Spin_result present(const std::function<void(Spin_result&)>& place = {});
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
