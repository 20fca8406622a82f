// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Dirac_linearization.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Potential_metric.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief spins lambda and a potential rho' that together minimise
///
///     alpha |(D - rho') lambda|^2_M + |rho' - rho|^2_K + sum |residuals of lambda|^2
///
/// where the mean of |lambda|^2 is one: the surface near that of rho that has what the residuals
/// want, without being an eigenvector of anything. Without residuals, [CGP (5.3)] is the limit of
/// small alpha; on a given mesh, lambda tends to 1 as alpha grows, because (D - rho') lambda = 0
/// has more equations than unknowns.
///
/// The first term is what does not close up and what the mesh cannot represent. K is that of
/// `Potential_metric` with s = R^2 / 10, R^2 = area / (4 pi); constants of rho' cost nothing there,
/// because they have no effect. All terms are numbers without a unit.
///
/// Each step solves the linear least-squares problem of the derivatives (Gauss-Newton): changes d
/// of rho' are eliminated with the scalar H = K + alpha N^T M N (`Potential_metric::couple()`), and
/// the Schur complement for changes of lambda, which is linear over the real numbers only, is
/// solved by conjugate gradients preconditioned by the factor of X + shift, which is kept while
/// lambda moves little. Right factors of lambda, among them its length, are gauge: all four real
/// directions are left out.
class Relaxed_spins {
 public:
  using Spins = Quaternion_vector<double>;

  struct Options {
    double alpha = 0;        ///< > 0; 0: `default_misfit_weight()`
    double tolerance = 0.3;  ///< of conjugate gradients
    int max_iterations = 30;
    double reuse = 0.2;  ///< the factor is kept while lambda has moved by less, in the mean
  };

  struct Costs {
    int factorizations = 0, solves = 0;                ///< quaternionic
    int scalar_factorizations = 0, scalar_solves = 0;  ///< of H
    Dirac_evidence::Seconds seconds;
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

  struct Progress {
    double before = 0, after = 0;  ///< the sum of the terms
    double length = 0;             ///< of the step, at most 1; 0: no step makes the sum smaller
    double moved = 0;              ///< relative change of lambda, root mean square
    int iterations = 0;            ///< of conjugate gradients
  };

  /// \param system of a closed surface; its factor is replaced
  /// \param rho wanted, in 1/length; rho' starts as 0 where it has its values
  /// \param residuals must outlive the object
  Relaxed_spins(Dirac_system& system, const Curvature_potential& rho, Spin_residuals residuals,
                const Options& options);

  const Spins& lambda() const { return m_lambda; }
  const Curvature_potential& rho() const { return m_rho; }  ///< rho'
  const Costs& costs() const { return m_costs; }
  double alpha() const { return m_alpha; }

  /// asks for another rho, where the first has its values
  void want(const Eigen::VectorXd& rho) { m_wanted = rho; }

  /// of conjugate gradients from now on
  void set_tolerance(double tolerance) { m_options.tolerance = tolerance; }

  /// \param lambda whose length does not matter
  void restart(const Spins& lambda, const Eigen::VectorXd& rho);

  /// the terms here
  Terms terms() const { return terms_at(m_lambda, m_rho.values); }

  /// \brief half the gradient of the sum of the terms, with respect to lambda and rho'.
  Step gradient();

  /// \brief S y, the Schur complement of half the Hessian of Gauss and Newton.
  /// \pre `linearize()` was called last
  Spins schur_product(const Spins& y);

  /// takes the derivatives here, and factors H, and X where its factor is too old
  void linearize();

  /// the least-squares step. \pre `linearize()` was called last
  Step step();

  /// \brief takes a step, or a part of it: never one that makes the sum larger, or brings a spin
  /// near zero.
  Progress advance();

 private:
  Spins normalized(Spins lambda) const;
  Terms terms_at(const Spins& lambda, const Eigen::VectorXd& rho) const;
  void factorize();
  Eigen::VectorXd stiffness() const;
  Eigen::VectorXd metric_product(const Eigen::VectorXd& d) const;
  Eigen::VectorXd solve_potential(const Eigen::VectorXd& b);
  Spins residual_product(const Spins& y) const;
  Spins without_gauge(Spins y) const;
  Spins without_gauge_gradient(Spins g) const;
  Spins solve_schur(const Spins& b, int& iterations);
  bool is_far_from_zero(const Spins& lambda) const;

  Dirac_system& m_system;
  Spin_residuals m_residuals;
  Options m_options;
  double m_alpha;
  Potential_metric m_metric;
  bool m_constants_are_free;
  Eigen::VectorXd m_wanted;
  Spins m_lambda;
  Curvature_potential m_rho;
  std::optional<Dirac_linearization> m_linear;
  Eigen::VectorXd m_constants;  // H^-1 of the areas, where constants are free
  double m_moved = 0;           // since the factor of X
  double m_factored_stiffness = -1;
  int m_factored_changes = -1;
  int m_iterations = 0;
  Costs m_costs;
};

/// \ingroup PkgSpin
/// \brief alpha = R^2 / (10 h^2) with h the mean length of edges: such that the misfit of the
/// result falls faster than h under refinement.
double default_misfit_weight(const Surface_ref& surface);

}  // namespace Conformal_geometry_processing::internal
