// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_ref.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// options of `solve_dirac_equation()`
struct Dirac_options {
  /// the eigenvector of D - rho that is taken if directions are prescribed at a boundary
  enum class Branch {
    nearest,   ///< the nearest to the spins that turn the boundary least and are harmonic inside;
               ///< unless it nearly is these, of those whose eigenvalue is zero, if there are any
    smallest,  ///< the one whose eigenvalue has the smallest modulus
    zero       ///< the nearest among those whose eigenvalue is zero up to the discretisation error,
               ///< even where other eigenvalues have surfaces, too; if there is none, the smallest
  };

  /// the discrete eigenvalue problem for (D - rho) lambda = gamma lambda
  enum class Eigenproblem {
    standard,    ///< X lambda = mu M_V lambda [CGP (5.3)]; always applicable
    generalized  ///< X lambda = gamma B^H M_F (D - R) lambda [CGP (5.2)]; rho on faces
  };

  Eigenproblem problem = Eigenproblem::standard;
  double tolerance = 1e-8;  ///< upper bound of `Dirac_solution::residual`
  int max_iterations = 200;
  int max_substeps = 10;     ///< stages in which the branch is followed, each with a factorization
  unsigned random_seed = 0;  ///< of start vectors, with directions or the generalized problem
  /// with prescribed directions at a boundary: singular values of D - rho up to this bound, in
  /// 1/length, count as zero, and the solution is the combination of their vectors nearest to the
  /// guide
  double kernel_tolerance = 0;
  Branch branch = Branch::nearest;
  internal::Eigensolver_ref eigensolver;  ///< for closed surfaces
};

namespace internal {

/// \brief the numbers that verify a solution of the Dirac equation.
struct Dirac_evidence {
  bool converged = false;  ///< the equation is solved to the tolerance
  bool cancelled = false;  ///< the visitor cancelled

  /// lambda is that of `Relaxed_spins`, with another potential rho': no eigenvector, and
  /// `residual`, `gap` and `branch_gap` have no meaning
  bool is_relaxed = false;

  /// its search ended at a budget of iterations, with the best that it had
  bool is_unfinished = false;

  double eigenvalue = 0;  ///< gamma, signed, in 1/length; the mean of rho' - rho
  double residual = 0;    ///< estimate of the error of lambda: the norm of X lambda - mu M_V lambda
                          ///< dual to the energy, divided by sqrt(4 pi / area) |lambda|
  /// |(D - rho - gamma) lambda| / |lambda|, or of D - rho', in 1/length: what the mesh leaves of
  /// the equation
  double dirac_residual = 0;
  /// distance from gamma to the nearest other eigenvalue that was found, in 1/length: an upper
  /// bound of the true gap. Zero, and in no report, if no other was looked for, as where the
  /// boundary is free, or where the vector of prescribed directions is near enough to the guide.
  double gap = 0;
  double branch_gap = 0;   ///< the least gap on the way from rho = 0, on closed surfaces: where it
                           ///< is small, another branch crosses
  double overlap = 0;      ///< |<lambda, 1>| / (|lambda| |1|), one for the identity
  int iterations = 0;      ///< of the eigensolver
  int substeps = 1;        ///< stages in which the branch was followed from rho = 0
  int factorizations = 0;  ///< of X, also in attempts that were given up
  int solves = 0;          ///< with a factor of X, one right-hand side each
  double spectral_shift = 0;    ///< sigma of the last factor, of X for rho + sigma
  bool is_generalized = false;  ///< the generalized problem was requested, solved and accepted
  double generalized_eigenvalue = 0;  ///< eigenvalue of (5.2), gamma + (mu - gamma^2) / gamma

  /// wall clock seconds
  struct Seconds {
    double assembly = 0, factorization = 0, eigenvectors = 0;
  };
};

/// a solution of the Dirac equation
struct Dirac_solution : Dirac_evidence {
  Quaternion_vector<double> lambda;  ///< |V|; mean real and positive, mean of |lambda|^2 one
  double energy = 0;     ///< mu = <lambda, X lambda> / <lambda, M_V lambda> >= 0, of rho + gamma on
                         ///< closed surfaces
  Seconds seconds;       ///< of each stage
  int largest_span = 0;  ///< vectors of the largest span in which the branch was followed
};

/// adds the iterations, factorizations and solves of another solution, one of which may be
/// unfinished
void add_costs(Dirac_evidence& all, const Dirac_evidence& next);

void add_costs(Dirac_evidence::Seconds& all, const Dirac_evidence::Seconds& next);

}  // namespace internal

/// \ingroup PkgSpin
/// the evidence for the surface scaled by `unit`: divides the numbers in 1/length by `unit`
internal::Dirac_evidence in_units(internal::Dirac_evidence evidence, double unit);

}  // namespace Conformal_geometry_processing
