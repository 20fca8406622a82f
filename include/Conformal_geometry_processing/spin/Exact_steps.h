// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_EXACT_STEPS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_EXACT_STEPS_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <optional>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief applies rho to a surface with handles or holes in steps that keep its edges exact, see
/// `Spin_transformation`.
///
/// The quantity that adds up over transformations is the half-density rho |df|. The inexact part of
/// rho is discarded: a retry, with a shrinking rest of the path to compensate for it, would lead to
/// ever larger steps.
template <class Transformation>
class Exact_steps {
 public:
  /// \param transformation is moved along the path
  /// \param rho in 1/length
  Exact_steps(Transformation& transformation, const Curvature_potential& rho,
              const Spin_transformation_options& options);

  /// see `Spin_transformation::transform()`
  Spin_result run(const Dirac_options& options, const Go_further& go_further);

 private:
  void go_all_the_way(const Dirac_options& options, const Go_further& go_further, Spin_result& all);

  /// the part of the missing rho that keeps the edges exact; none if the surface has none any more
  std::optional<Eigen::VectorXd> exact_part(bool has_moved);

  /// \brief tries `step` times v and smaller steps until one is accepted.
  /// \returns nothing if no step of at least the minimal size is accepted, or the visitor cancels
  std::optional<Spin_result> largest_step(const Eigen::VectorXd& v, const Dirac_options& options,
                                          const Go_further& go_further, Spin_report& all,
                                          double& step);
  bool can_go_on_from(const Points& positions);
  double best_step(double step, double defect) const;
  double next_step(double step, double defect, double rest) const;

  /// continues from the surface found: converts rho to it with rho |df| fixed
  void take(const Eigen::VectorXd& v, double share);

  /// the areas that belong to the values of rho, in the unit of the mesh
  Eigen::VectorXd areas() const;

  /// the angles between the boundary and the prescribed directions, or its initial ones
  void measure_directions(Spin_report& report) const;

  /// root of the integral of rho^2, without the mean of rho if constants have no effect; invariant
  /// under scaling
  double norm(const Eigen::VectorXd& rho) const;

  Transformation& m_transformation;
  const Spin_transformation_options& m_options;
  Normalized_frame m_frame;       // of the first surface
  Mesh_view m_before;             // on which the whole path is measured
  Curvature_potential m_missing;  // remaining rho, on the present surface
  Eigen::VectorXd m_left_out;     // part of rho that cannot be realised
  Eigen::VectorXd m_areas;        // of the surface of `m_missing`
  Points m_directions;            // prescribed at the boundary, if any
};

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Exact_steps_templates.h>
#endif

#endif
