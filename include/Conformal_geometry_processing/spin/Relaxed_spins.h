// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Dirac_misfit.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Spin_gauge.h>
#include <Conformal_geometry_processing/spin/Spin_preconditioner.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/dense/Solver_status.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

#include <functional>
#include <optional>

namespace Conformal_geometry_processing::internal {

/// \brief the inner product K = M + s L of changes of rho at vertices, which approximates
///
///     integral a b + s <grad a, grad b>,
///
/// and the solution of (K + w M) d = b. M are the areas, and L is the cotan Laplacian, which
/// annihilates constants.
class Potential_metric {
 public:
  /// \param system whose surface is meant, and whose analysis is shared
  /// \param s >= 0, in the unit of area of the system
  Potential_metric(const Dirac_system& system, double s);

  /// \brief factors K + w M, for `solve_coupled()`.
  /// \throw Solver_error if the factorization fails
  void couple(double w);

  /// \brief (K + w M)^-1 b, for all columns of b at once.
  /// \throw Solver_error if the solver fails
  Eigen::MatrixXd solve_coupled(const Eigen::MatrixXd& b) const;

  /// M, |V|
  const Eigen::VectorXd& areas() const { return m_areas; }

  /// K d, for each column of d
  Eigen::MatrixXd apply(const Eigen::MatrixXd& d) const;

  /// <d, K d>
  double squared_norm(const Eigen::VectorXd& d) const { return m_part.sum(d.dot(apply(d).col(0))); }

 private:
  static void check(Solver_status status);

  Surface_part m_part;
  Eigen::VectorXd m_areas;
  Hermitian_sparse_matrix<double> m_matrix;  // K
  Solver_ref<double> m_coupled;              // of K + w M
};

/// \brief spins lambda and a potential rho' that together minimise
///
///     |(D - rho') lambda / |lambda||^2_W + |rho' - rho|^2_K + sum |residuals of lambda|^2
///
/// where the mean of |lambda|^2 is one: the surface near that of rho that has what the residuals
/// want, without being an eigenvector of anything. Without residuals, [CGP (5.3)] is the limit of
/// small weights W.
///
/// The first term is what does not close up and what the mesh cannot represent, see `Dirac_misfit`.
/// K is that of `Potential_metric`; s is R^2 / 10 where not said otherwise, R^2 = area / (4 pi).
/// Where gamma is an eigenvalue, constants of rho' cost nothing, because they have no effect. All
/// terms are numbers without a unit. Prescribed directions restrict lambda to their space; with a
/// free boundary, there is a small weight of lambda - 1.
///
/// Each step solves the linear least-squares problem of the derivatives (Gauss-Newton): changes d
/// of rho' are eliminated with the scalar H = K + (the sum of the weights) M, a bound of K + N^T W
/// N that is nearly sharp, since the weight of vertices is large, and does not depend on lambda;
/// the Schur complement for changes of lambda, which is linear over the real numbers only, is
/// solved by conjugate gradients with a `Spin_preconditioner`. Right factors of lambda are left
/// out, see `Spin_gauge`.
class Relaxed_spins {
 public:
  using Spins = Quaternion_vector<double>;
  using Vectors = Block<Quaternion<double>>;

  struct Options {
    Misfit_weights weights;
    double tolerance = 0.3;  ///< of conjugate gradients, and
    double negligible = 0;   ///< what they may leave of the sum, where no residuals are few
    int max_iterations = 30;
    double smoothness = 0.1;  ///< s of K, by R^2
    double reuse = 0.2;       ///< the factor is kept while lambda has moved by less, in the mean
  };

  struct Terms {
    double misfit = 0, potential = 0, residuals = 0;
    double sum() const { return misfit + potential + residuals; }
  };

  /// a change, and half the derivative of the sum in its direction, which is negative
  struct Step {
    Spins spins;
    Eigen::VectorXd potential;
    double slope = 0;
  };

  /// an unknown t that changes half the gradient by -t force, to first order, as the log of a
  /// weight does
  struct Unknown {
    Spins force;
    Spins response;  ///< of the spins to the force, if that is known well enough, or empty
    /// of the spins that a step leads to, and how they change with t: sets t, and returns it
    std::function<double(const Spins& there, const Spins& response)> choose;
  };

  struct Progress {
    double before = 0, after = 0;  ///< the sum of the terms
    double length = 0;             ///< of the step, at most 1; 0: no step makes the sum smaller
    double moved = 0;              ///< relative change of lambda, root mean square
    bool cancelled = false;        ///< and no step was made
    int iterations = 0;            ///< of conjugate gradients
  };

  /// \param system without prescribed positions; its factor is replaced
  /// \param rho wanted, |V|, in 1/length; rho' starts as 0
  /// \param residuals must outlive the object
  Relaxed_spins(Dirac_system& system, Eigen::VectorXd rho, Spin_residuals residuals,
                const Options& options);
  Relaxed_spins(const Relaxed_spins&) = delete;
  Relaxed_spins& operator=(const Relaxed_spins&) = delete;

  const Spins& lambda() const { return m_lambda; }
  const Eigen::VectorXd& rho() const { return m_rho; }  ///< rho'
  const Relaxed_costs& costs() const { return m_costs; }
  void reset_costs() { m_costs = {}; }
  const Misfit_weights& weights() const { return m_weights; }

  /// the spins to start with: 1, or the guide of prescribed directions
  Spins start() const;

  /// asks for another rho
  void want(const Eigen::VectorXd& rho) { m_wanted = rho; }

  /// of conjugate gradients from now on
  void set_tolerance(double tolerance) { m_options.tolerance = tolerance; }

  /// multiplies the weights of the misfit
  void stiffen(double factor);

  /// \param lambda whose length does not matter where it is gauge
  void restart(const Spins& lambda, const Eigen::VectorXd& rho);

  /// where the factor for the next step was made
  Spin_preconditioner::Origin factored() const { return m_preconditioner.origin(); }

  /// \brief makes that of another search.
  /// \throw Solver_error if the factorization fails
  void factorize_at(const Spin_preconditioner::Origin& origin)
  {
    m_preconditioner.factorize_at(origin, m_costs);
  }

  /// the terms here
  Terms terms() const { return terms_of(here()); }

  /// \brief half the gradient of the sum of the terms, with respect to lambda and rho'.
  Step gradient();

  /// S y, the Schur complement of half the Hessian of Gauss and Newton, for each column of y.
  /// \pre `linearize()` was called last
  Vectors schur_product(const Vectors& y);

  /// takes the derivatives of the residuals here, and factors X where its factor is too old
  void linearize();

  /// the least-squares step.
  /// \pre `linearize()` was called last
  Step step(const Unknown& unknown = {}, const std::function<bool()>& go_further = {});

  /// \brief takes a step, or a part of it: never one that makes the sum larger, or brings a spin
  /// near zero.
  /// \param go_further called after each iteration of conjugate gradients; if it returns false, no
  /// step is made
  /// \param unknown one that is found with it
  Progress advance(const std::function<bool()>& go_further = {}, const Unknown& unknown = {});

  /// \brief takes a step of Newton's method for the few residuals alone, by the least change of
  /// lambda, as after `advance()` with a weight of them that leaves a little of them.
  /// \param is_anew with the derivatives here, otherwise those of the last `linearize()`
  /// \pre there are such residuals
  void meet_few(bool is_anew);

 private:
  Dirac_misfit misfit(const Spins& lambda, const Eigen::VectorXd& rho) const;
  const Dirac_misfit& here() const;
  Terms terms_of(const Dirac_misfit& there) const;
  double product(const Step& gradient, const Step& step) const;
  Eigen::VectorXd metric_product(const Eigen::VectorXd& d) const;
  void couple();
  Eigen::MatrixXd solve_potential(const Eigen::MatrixXd& b);
  Vectors solve_schur(Vectors b, const std::function<bool()>& go_further);
  bool is_far_from_zero(const Spins& lambda) const;

  Dirac_system& m_system;
  Spin_gauge m_gauge;
  Options m_options;
  Dirac_misfit::Geometry m_geometry;
  Misfit_weights m_weights;
  std::optional<Nearness_residual> m_nearness;  // with a free boundary
  Spin_residuals m_residuals;
  Potential_metric m_metric;
  Spin_preconditioner m_preconditioner;
  bool m_constants_are_free;
  Eigen::VectorXd m_wanted;
  Spins m_lambda;
  Eigen::VectorXd m_rho;
  mutable std::optional<Dirac_misfit> m_here;  // at lambda and rho', if it is known
  Eigen::VectorXd m_constants;                 // H^-1 of the areas, where constants are free
  int m_iterations = 0;                        // of the last step
  Relaxed_costs m_costs;
};

/// \brief 1.5 R / h with h the mean over the area of the edges of equilateral triangles of the
/// areas of the sheets, which slivers do not change: such that the misfit of the result falls like
/// h under refinement, and the iterations of a step grow like the root of 1 / h.
double default_vertex_weight(const Surface_ref& surface, const Surface_part& part = {});

}  // namespace Conformal_geometry_processing::internal
