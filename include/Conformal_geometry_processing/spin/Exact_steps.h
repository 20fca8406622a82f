// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Period_limit.h>
#include <Conformal_geometry_processing/spin/Spin_result.h>
#include <Conformal_geometry_processing/spin/Spin_transformation_options.h>
#include <Conformal_geometry_processing/spin/closed_step.h>

#include <Eigen/Core>

#include <optional>

namespace Conformal_geometry_processing {

class Spin_transformation;

namespace internal {

/// \brief applies rho to a surface with handles or holes in steps that keep its edges exact, see
/// `Spin_transformation`.
///
/// The quantity that adds up over transformations is the half-density rho |df|. The inexact part of
/// rho is discarded: a retry, with a shrinking rest of the path to compensate for it, would lead to
/// ever larger steps. Where prescribed directions turn the boundary, they contribute periods of
/// first order, too, and rho and they may close together: the first step goes all the way with all
/// of rho, and adds what `closed_step()` needs.
class Exact_steps {
 public:
  /// \param transformation is moved along the path, to the last surface that a step starts from
  /// \param rho in 1/length
  Exact_steps(Spin_transformation& transformation, const Curvature_potential& rho,
              const Spin_transformation_options& options);

  /// see `Spin_transformation::transform()`
  Spin_result run(const Dirac_options& options, const Go_further& go_further);

 private:
  /// ends after a step with which lengths exceed a bound by far: another rho is looked for then
  void go_all_the_way(const Dirac_options& options, const Go_further& go_further, Spin_result& all);

  /// the part of the missing rho that keeps the edges exact; none if the surface has none any more
  std::optional<Eigen::VectorXd> exact_part(bool has_moved);

  /// \brief tries `step` times v and smaller steps until one is accepted.
  /// \returns nothing if no step of at least the minimal size is accepted, or the visitor cancels
  std::optional<Closed_step> largest_step(const Eigen::VectorXd& v, const Dirac_options& options,
                                          const Go_further& go_further, Spin_report& all,
                                          double& step);

  /// moves the transformation to the positions, unless they are the end of the path
  bool can_go_on_from(const Points& positions, bool is_end);

  /// the step whose defect would be the limit
  double best_step(double step, const Spin_report& report) const;
  double next_step(double step, const Spin_report& report, double rest) const;

  /// continues from the surface found: converts rho to it with rho |df| fixed
  /// \param v the exact part of the missing rho \param rho the part of it that the step realised
  void take(const Eigen::VectorXd& v, double share, const Eigen::VectorXd& rho);

  /// the certificate from the first surface to the last
  void finish(Spin_result& all) const;

  /// the shares of rho that are missing and added
  void tell_shares(Spin_report& report) const;

  /// the areas that belong to the values of rho, in the unit of the mesh
  Eigen::VectorXd areas() const;

  /// the angles between the boundary and the prescribed directions, or its initial ones
  void measure_directions(const Points& positions, Spin_report& report) const;

  /// root of the integral of rho^2, without the mean of rho if constants have no effect; invariant
  /// under scaling
  double norm(const Eigen::VectorXd& rho) const;

  Spin_transformation& m_transformation;
  const Spin_transformation_options& m_options;
  Period_limit m_limit;
  Normalized_frame m_frame;        // of the first surface
  Mesh_view m_before;              // on which the whole path is measured
  Curvature_potential m_missing;   // remaining rho, on the present surface
  Eigen::VectorXd m_wanted;        // all of rho, on the present surface
  Eigen::VectorXd m_left_out;      // part of rho that cannot be realised
  Eigen::VectorXd m_areas;         // of the surface of `m_missing`
  Eigen::VectorXd m_vertex_areas;  // of the first surface
  Points m_directions;             // prescribed at the boundary, if any
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
