// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Exactness_residual.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Potential_search.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>
#include <Conformal_geometry_processing/spin/Scale_residual.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief finds the rho' nearest to rho whose transformation changes lengths by no more than a
/// bound, relative to wanted factors: minimises
///
///     <rho' - rho, K (rho' - rho)> + w integral weight u^2,    u the log of the factor
///
/// with the inner product K of `Potential_search`, for the smallest w with which 98 % of the area
/// are within the bound. What is wide against the limbs *is* scale, and is reduced; what is narrow
/// survives. \tparam SolverTraits, EigensolverTraits see `Spin_transformation`
class Scale_search {
 public:
  using Search = Potential_search;
  using Limit_of_periods = std::function<double(const Dirac_solution&)>;

  /// a rho' that was tried
  struct Trial {
    Search::Candidate candidate = {};
    double weight = 0;            // w times m_unit
    double exactness_weight = 0;  // of the inexact part of the edges
    double excess = std::numeric_limits<double>::infinity();
    double inexact = std::numeric_limits<double>::infinity();
    double open = std::numeric_limits<double>::infinity();  // at most 1: handles count as closed

    /// square of the norm of rho' - rho
    double distance() const { return candidate.sum - candidate.residuals.squaredNorm(); }

    /// at most 1 if it is within the bound, and its edges close up
    double reach() const { return (std::max)(excess, inexact / inexact_limit()); }
  };

  /// \param system of the surface, \param rho in 1/length of it
  /// \param control with a bound; must outlive the object
  /// \param reconstruction of the surface
  /// \param exactness to keep handles and holes closed, or null
  /// \param period_limit of the surface that a solution gives
  Scale_search(Dirac_system& system, Curvature_potential rho, const Scale_control& control,
               const Poisson_reconstruction& reconstruction, const Exactness_constraints* exactness,
               Limit_of_periods period_limit);

  /// \brief searches w, and a weight for the inexact part of the edges where these do not close up.
  /// \param share of rho that is wanted, in (0, 1]
  /// \param from what was found for another share, to continue from; null: begins at rho' = 0
  /// \returns the solution for rho'; that nearest to the bound if none
  /// is within it
  Dirac_solution run(double share, const Trial* from, const Dirac_options& options,
                     const Go_further& go_further);

  /// the rho' of the last solution
  const Trial& best() const { return m_best; }

  /// the factors of lengths of the last solution, and what it has kept of rho
  Spin_report::Scales scales() const;

 private:
  /// tries weights, from the first in both directions, until the lengths are within the bound
  void search_weight(double first, const Dirac_options& options, const Go_further& go_further);

  /// \brief where the edges of the best result do not close up, adds their inexact part to the sum,
  /// with weights that grow until they do.
  ///
  /// It takes that part out of rho which the mesh cannot represent.
  void search_exactness(const Dirac_options& options, const Go_further& go_further);

  /// \brief moves the best rho' towards one beyond the bound, until it has reached the bound.
  ///
  /// Between the minima for two weights, all are minimal to second order, and cost one
  /// factorization each. Where the spins do not follow, minimises for a weight between instead.
  /// Where no weight has led beyond the bound, it moves towards rho itself, which is nearer if not
  /// minimal; on surfaces without handles, for these would open.
  void come_up_to_bound(const Dirac_options& options, const Go_further& go_further);

  /// minimises for w and takes the result if it is better
  /// \returns whether the minimum was reached
  bool try_weight(double w, const Dirac_options& options, const Go_further& go_further);

  /// \brief tries the rho' at t between the best one and that beyond the bound, or rho itself.
  ///
  /// Handles that have opened on the way are closed by minimising from there.
  /// \returns whether it was found there, on the same branch
  bool move_between(double t, const Dirac_options& options, const Go_further& go_further);

  /// likewise by the minimum for the weight between, from the best rho'
  void minimize_between(double t, const Dirac_options& options, const Go_further& go_further);

  double weight_between(double t) const
  {
    return is_any_beyond() ? m_best.weight * std::pow(m_beyond.weight / m_best.weight, t)
                           : m_best.weight;
  }

  /// \brief the period defect of a solution relative to what counts as closed.
  ///
  /// The limit costs a surface: it is asked for only where it matters.
  double openness(const Search::Candidate& found) const;

  /// takes the present rho' if it is better than the best one, or nearer beyond the bound
  void judge(double w);

  /// \brief whether it is nearer to rho than the best one, or that has a fault that it has less of:
  /// lengths, then edges, then handles that do not close up.
  bool is_better(const Trial& trial) const;

  bool is_any_beyond() const { return std::isfinite(m_beyond.reach()); }

  /// whether the best result is within the bound, and its edges close up
  bool is_found() const { return m_best.reach() <= 1; }
  static constexpr double period_tolerance = 1e-5;
  static double inexact_limit() { return 0.95 * Spin_report::Limits().closure; }

  const Surface_ref m_surface;
  const bool m_is_closed;
  const Curvature_potential m_rho;
  Eigen::VectorXd m_wanted;  // the share of it
  Scale_residual m_scales;
  Exactness_residual m_inexact;
  std::optional<Period_residual> m_periods;
  Search m_search;
  const Scale_control& m_control;
  const Limit_of_periods m_period_limit;
  Eigen::VectorXd m_areas;
  double m_unit;  // the square of the radius of the sphere of the same area
  Trial m_last, m_best;
  Trial m_beyond;  // the nearest one beyond the bound
};

}  // namespace Conformal_geometry_processing::internal
