// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Exactness_residual.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Position_residual.h>
#include <Conformal_geometry_processing/spin/Potential_search.h>
#include <Conformal_geometry_processing/spin/Scale_residual.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/spin/Target_mismatch.h>

#include <Eigen/Core>

#include <optional>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief finds the rho whose transformation comes nearest to a given surface: minimises
///
///     <rho - rho_0, K (rho - rho_0)> + w / R^2 distance^2 + c closure^2 + s integral u^2 / R^2
///
/// by `Potential_search`, with the mean square distance of vertices from targets after the best
/// similarity (`Position_residual`), the part of the edges that does not close up
/// (`Exactness_residual`) and, with a bound on lengths, the log factors u of lengths
/// (`Scale_residual`); R is the radius of the sphere of the same area. Handles and holes stay
/// closed by constraints.
///
/// The weight w of the distance grows as long as surfaces verify and are within the bound: what is
/// far from conformal would be approached by wrinkles that the mesh cannot represent. For the same
/// reason, the result is the surface with the least mismatch of positions and normals together
/// (`Target_mismatch`), and the search ends where it grows, or where nobody sees the rest. Where
/// targets are nearly reached, rho_0 is replaced by the best rho found so far, so that what remains
/// of the distance is not that of rho_0.
class Target_search {
 public:
  using Transformation = Spin_transformation;
  using Search = Potential_search;
  using Candidate = Search::Candidate;

  /// \param transformation must outlive the object
  /// \param targets 3 x |V|, in the frame of the transformation
  /// \param start rho_0, in 1/length of the frame
  /// \param mismatch of surfaces and targets; must outlive the object
  /// \param exactness what keeps the edges closed around handles and holes, or null
  Target_search(Transformation& transformation, const Points& targets,
                const Target_mismatch& mismatch, const Scale_control& scales,
                Curvature_potential start, const Exactness_constraints* exactness);

  /// \brief searches from the given rho, and its solution if it is known, otherwise from rho = 0.
  /// \throw Solver_error if a factorization fails
  void run(const std::optional<Dirac_solution>& start, const Dirac_options& options,
           const Go_further& go_further);

  /// the surface of least mismatch that verifies, its spins and the costs of the search; none was
  /// found if it has no positions
  const Spin_result& best() const { return m_best; }

  /// its rho, in 1/length of the frame
  const Curvature_potential& potential() const { return m_nearest.rho; }

 private:
  /// minimises for a weight, raises that of scales until they are within the bound, and takes the
  /// result if it verifies and has less mismatch
  /// \returns whether it verifies
  bool try_weight(double w, const Dirac_options& options, const Go_further& go_further);

  /// goes on from the best result, near to the target, with rho_0 its rho, as long as the distance
  /// is halved
  void polish(double w, const Dirac_options& options, const Go_further& go_further);

  /// searches on, near to a candidate
  void restart(const Candidate& from);

  /// whether nobody sees the rest of the distance
  bool is_reached() const { return m_mismatch.is_reached(m_distance, m_normal_distance); }

  /// the present surface with its report
  Spin_result present();

  Transformation& m_transformation;
  const Target_mismatch& m_mismatch;
  const Scale_control& m_control;
  Eigen::VectorXd m_areas;
  const Exactness_constraints* m_exactness;
  Position_residual m_positions;
  Exactness_residual m_inexact;
  Scale_residual m_scales;
  std::optional<Period_residual> m_periods;
  Candidate m_nearest;  // what the best result was made of; at first, only rho_0
  Search m_search;
  double m_unit, m_scale_weight = 1;     // the square of R; s
  double m_last, m_least;                // mismatch of the last result, and of the best
  double m_distance, m_normal_distance;  // of the best result
  Spin_result m_best;
};

}  // namespace Conformal_geometry_processing::internal
