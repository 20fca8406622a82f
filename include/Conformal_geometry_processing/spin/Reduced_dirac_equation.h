// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_REDUCED_DIRAC_EQUATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_REDUCED_DIRAC_EQUATION_H

#include <Conformal_geometry_processing/algebra/rotor.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Reduced_hermitian_solver.h>
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief solves (D - rho) lambda = gamma lambda for spins that turn directions at the boundary
/// into prescribed ones: the smallest singular value of D - rho on that space, or one of the next
/// whose vector is nearer to the guide [CGP 5.7]. Where gamma is only a misfit, no vector with a
/// great one is taken if there are others (`greatest_misfit()`).
///
/// The space is one over the real numbers, so eigenvalues are simple in general and not fourfold.
/// Per `solve()`: one factorization, and one solve for each iteration and column.
///
/// \tparam Problem a `Dirac_eigenproblem`
/// \tparam Directions `Prescribed_directions`
template <class Problem, class Directions>
class Reduced_dirac_equation {
  using Vectors = Block<Quaternion<double>>;

 public:
  /// squares of overlaps with orthogonal vectors add up to at most one, so that no other vector is
  /// nearer to the guide than one with this overlap
  static constexpr double surely_nearest = 0.75;

  /// \param problem, directions must outlive the object
  /// \throw Solver_error if the analysis fails
  Reduced_dirac_equation(Problem& problem, const Directions& directions);

  /// solves with R = B^T (X + shift) B for the last rho
  const Reduced_hermitian_solver& solver() const { return m_solver; }

  /// gives back the memory of the factor, until the next `solve()`
  void release() { m_solver.release(); }

  /// \brief assembles X for rho and factors R, shifted as `Dirac_eigenproblem` does.
  /// \throw Solver_error if R is not positive definite to rounding, or memory is short
  void set_potential(const Curvature_potential& rho, Dirac_solution::Seconds& seconds);

  /// \brief B R^-1 B^T c for rho = 0, with a shift so small that it counts along the kernel only:
  /// the change of lambda = 1 that answers to sources c.
  /// \throw Solver_error if R cannot be factored
  Vectors response(const Vectors& c);

  /// \param[in,out] s is filled in
  /// \param is_self_adjoint whether gamma has a sign
  void solve(const Curvature_potential& rho, bool is_self_adjoint, const Dirac_options& options,
             Dirac_solution& s, const Go_further& go_further);

 private:
  Solver_status factorize(double share);
  static void check(const char* step, Solver_status status);

  /// One column, if it comes near to the guide; else several, of which those that count converge.
  Eigensolver_result nearest_to_guide(const Dirac_options& options, double bound, Dirac_solution& s,
                                      const Go_further& go_further) const;
  Eigensolver_result smallest(Vectors start, int wanted, double tolerance,
                              const Dirac_options& options, Dirac_solution& s,
                              const Go_further& go_further) const;

  /// the first columns and X^-1 of noise
  Vectors with_noise(const Vectors& first, int columns, unsigned seed) const;

  /// how many of the eigenvectors have to be exact
  int wanted(const Eigensolver_result& r, const Dirac_options& options, double bound) const;
  static double singular_value(const Eigensolver_result& r, int c);

  /// that of the branch: of those that are solutions up to the discretisation, if there are some
  int column(const Eigensolver_result& r, const Dirac_options& options, double bound) const;

  /// the number of singular values that count as zero; of none, one is as good
  int size_of_kernel(const Eigensolver_result& r, const Dirac_options& options) const;

  /// the vector nearest to the guide, or the projection of the guide on the kernel
  void take(const Eigensolver_result& r, const Dirac_options& options, double bound,
            Dirac_solution& s) const;

  /// the sign of the guide, and a mean of |lambda|^2 of one; no rotation, for directions are fixed
  void normalize(Quaternion_vector<double>& lambda) const;
  double overlap(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b) const;

  Problem& m_problem;
  const Directions& m_directions;
  Reduced_hermitian_solver m_solver;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Reduced_dirac_equation_templates.h>
#endif

#endif
