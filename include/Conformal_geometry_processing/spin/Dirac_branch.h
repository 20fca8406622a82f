// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_BRANCH_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_BRANCH_H

#include <Conformal_geometry_processing/spin/Dirac_search.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

namespace internal {

/// \brief solves (D - rho) lambda = gamma lambda on a closed surface, on the branch of eigenvalues
/// that tends to lambda = 1 as rho tends to zero [CGP (5.3)].
///
/// The thesis takes the eigenvalue of smallest modulus. If rho is strong or has a large mean, that
/// eigenvalue can belong to another branch; a vector is accepted only if its overlap with the
/// vector that it continues exceeds `same_branch`. If the first solve finds no such vector, rho is
/// increased from zero in substeps. Each substep searches for the eigenvalue nearest to the
/// predicted one, sigma: the eigenvalue of D - rho nearest to sigma is the smallest one of D - (rho
/// + sigma). Costs one numeric factorization per substep, and one more each time X mixes vectors of
/// opposite sign. The vectors of the first solve are kept: the continuation ends with the first
/// substep that comes near enough to one of them.
template <class SolverTraits, class EigensolverTraits>
class Dirac_branch {
  using System = Dirac_system<SolverTraits>;
  using Search = Dirac_search<SolverTraits, EigensolverTraits>;

 public:
  /// the overlap with the continued vector that a vector must exceed
  static constexpr double same_branch = Search::same_branch;

  /// \param system the system of a closed surface; must outlive the object
  explicit Dirac_branch(System& system) : m_system(system) {}

  /// see `solve_dirac_equation()`
  /// \param[in,out] s receives the solution
  /// \pre `set_potential(rho)` has been called
  void solve(const Curvature_potential& rho, const Dirac_options& options, Dirac_solution& s,
             const Go_further& go_further);

 private:
  /// one potential of the continuation
  struct Step {
    Curvature_potential rho;
    double sigma, tolerance;
    bool is_between = false;  ///< not the last step: an approximate vector suffices as a guide
  };
  /// eigenvectors of X for the potential rho + sigma
  struct Found {
    Eigensolver_result r;
    double sigma;
  };
  static constexpr int max_separations = 4;

  static Curvature_potential scaled(const Curvature_potential& rho, double t, double sigma);

  /// Replaces s.lambda by the eigenvector nearest to it. Returns false and leaves s.lambda
  /// unchanged if no vector found is on the same branch.
  bool follow(const Step& step, const Dirac_options& options, Dirac_solution& s,
              const Go_further& go_further);

  /// \brief finds the candidates for the continuation of s.lambda.
  ///
  /// If X has mixed lambda with a vector of opposite sign, a shift by the signed eigenvalue of
  /// lambda separates the two. The shift may bring in a third vector, so it is repeated; a mixture
  /// that remains is an error of a coarse mesh.
  Found find(const Step& step, Dirac_options options, Dirac_solution& s,
             const Go_further& go_further, bool is_factored = false);

  /// a result with the given vectors and unknown values and errors
  static Eigensolver_result unconverged(const Block<Quaternion<double>>& vectors);
  bool accept(const Found& found, double tolerance, Dirac_solution& s) const;

  static double root(double mu) { return std::sqrt((std::max)(mu, 0.)); }

  Eigen::Index nearest_column(const Block<Quaternion<double>>& vectors,
                              const Quaternion_vector<double>& guide) const;

  /// Continues s.lambda from 1 at t = 0 to an eigenvector of D - t rho at t = 1, in the largest
  /// steps that stay on the branch. Gives up when the substeps are used up.
  /// \param smallest vectors found without shift, none of which is near 1
  void continue_from_identity(const Curvature_potential& rho, const Dirac_options& options,
                              const Found& smallest, Dirac_solution& s,
                              const Go_further& go_further);

  /// d gamma / dt for D - t rho at the eigenvector lambda
  double slope_of(const Curvature_potential& rho, const Quaternion_vector<double>& lambda) const;

  /// Refines the approximate eigenvector to the tolerance: as an eigenvector of [CGP (5.3)] if the
  /// branch is among its smallest ones, otherwise of the shifted problem, whose matrix is factored.
  void finish(const Curvature_potential& rho, const Dirac_options& options, const Found& smallest,
              Dirac_solution& s, const Go_further& go_further);

  /// whether one of the vectors found without shift is on the branch of s.lambda
  bool is_continued_by(const Found& smallest, const Dirac_solution& s) const;

  System& m_system;
};

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Dirac_branch_templates.h>
#endif

#endif
