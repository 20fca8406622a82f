// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Conformal_deformation_options.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Position_residual.h>
#include <Conformal_geometry_processing/spin/Potential_search.h>
#include <Conformal_geometry_processing/spin/Scale_residual.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief finds the least rho whose transformation takes control points to targets up to a
/// similarity, on a way from where they are, see `Conformal_deformation`.
class Control_point_search {
 public:
  using Transformation = Spin_transformation;
  using Search = Potential_search;

  /// \param transformation must outlive the object
  /// \param options must outlive the object
  Control_point_search(Transformation& transformation, std::vector<Control_point> points,
                       const Conformal_deformation_options& options);

  /// whether these are the points of the search, with whatever targets
  bool is_for(const std::vector<Control_point>& points) const;

  /// \brief goes as far as surfaces are good, in steps along straight lines: from the result of
  /// the last run, with its gradients as long as they serve, or else from the initial surface.
  /// \param targets 3 x number of points, in the frame of the transformation
  /// \throw Solver_error if the first factorization fails
  void run(const Points& targets, const Dirac_options& options, const Go_further& go_further);

  double reached() const { return m_reached; }  ///< the share of the way
  int steps() const { return m_steps; }         ///< that were made

  /// the rho' found, with its solution
  const Search& search() const { return *m_search; }

  /// the bound on scales and what is within it
  Spin_report::Scales scales() const;

  /// how far the edges fail to close up around handles and holes
  double period_defect() const;

 private:
  /// the control points on the surface found so far
  Points present_points() const;

  /// adopts targets, moved to the present control points by the similarity that fits them best
  void set_targets(const Points& targets);

  /// as far as it gets, from the present surface to the targets
  void go(const Dirac_options& options, const Go_further& go_further);

  /// minimises for targets at a share of the way
  /// \returns whether the minimum was reached, and the surface can be a result; otherwise all is as
  /// it was
  bool go_to(double share, const Dirac_options& options, const Go_further& go_further);

  /// not flipped, and without a fault that a limit tells
  bool is_good() const;

  /// raises the weight of scales until they are within the bound
  void bound_scales(const Dirac_options& options, const Go_further& go_further);

  Transformation& m_transformation;
  const Conformal_deformation_options& m_options;
  const Exactness_constraints* m_exactness;  // or null
  std::vector<Control_point> m_points;
  Points m_from, m_to;  // the control points, at first and in the end
  bool m_has_run = false;
  Position_residual m_positions;
  Scale_residual m_scales;
  std::optional<Period_residual> m_periods;
  std::optional<Search> m_search;
  double m_unit, m_weight = 0;  // the square of R; the weight of scales
  double m_reached = 0;
  int m_steps = 0;
};

}  // namespace Conformal_geometry_processing::internal
