// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_EXACT_STEPS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_EXACT_STEPS_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <optional>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief applies rho to a surface with handles or holes in steps that keep its edges exact, see
/// `Spin_transformation`.
///
/// rho |df|, rho as a density of lengths, is what adds up over transformations. What was not exact
/// before is given up: to try it again, with ever less of the way left to make up for it, would end
/// in ever faster steps.
template <class Transformation>
class Exact_steps {
 public:
  /// \param transformation is moved along \param rho in 1/length
  Exact_steps(Transformation& transformation, const Curvature_potential& rho,
              const Spin_transformation_options& options);

  /// see `Spin_transformation::transform()`
  Spin_result run(const Dirac_options& options, const Go_further& go_further);

 private:
  void go_all_the_way(const Dirac_options& options, const Go_further& go_further, Spin_result& all);

  /// \brief tries `step` times v and smaller steps, until one is good enough to go there.
  /// \returns none if no step of the least size is, or the visitor said no
  std::optional<Spin_result> largest_step(const Eigen::VectorXd& v, const Dirac_options& options,
                                          const Go_further& go_further, Spin_report& all,
                                          double& step);
  bool can_go_on_from(const Points& positions);
  double best_step(double step, double defect) const;
  double next_step(double step, double defect, double rest) const;

  /// counts from the surface found, where rho becomes another one, as a density of lengths
  void take(const Eigen::VectorXd& v, double share);

  /// that belong to the values of rho, in the unit of the mesh
  Eigen::VectorXd areas() const;

  /// how far the boundary is from the directions prescribed, or those that it had in the beginning
  void measure_directions(Spin_report& report) const;

  /// root of the integral of rho squared, less its mean where that has no effect; does not depend
  /// on scale
  double norm(const Eigen::VectorXd& rho) const;

  Transformation& m_transformation;
  const Spin_transformation_options& m_options;
  Mesh_view m_before;             // on which the whole way is measured
  Curvature_potential m_missing;  // rho that is to come, on the present surface
  Eigen::VectorXd m_left_out;     // rho that cannot come
  Eigen::VectorXd m_areas;        // of the surface that `m_missing` is on
  Points m_directions;            // prescribed at the boundary, if any are
};

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Exact_steps_templates.h>
#endif

#endif
