// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/krylov/Lobpcg.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \brief solves (D - rho) lambda = gamma lambda for spins that turn directions at the boundary
/// into prescribed ones: takes the smallest singular value of D - rho on that space, or one of the
/// next whose vector is nearer to the guide [CGP 5.7]. If gamma is only a misfit, a vector whose
/// misfit exceeds `greatest_misfit()` is taken only if there are no others. If gamma is an
/// eigenvalue, vectors near to the guide may belong to any. One that nearly is the guide, as in
/// steps of a flow, is taken; else those that belong to zero come first, where rho is what was
/// asked for: the surface with wanted binormals may be far from the guide. `Branch::zero` leaves
/// out all others.
///
/// The space is real, so eigenvalues are in general simple and not fourfold. Each `solve()` costs
/// one factorization, and one solve for each iteration and column.
class Directions_selection {
 public:
  using Vectors = Block<Quaternion<double>>;

  /// squared overlaps with orthogonal vectors sum to at most one, so no other vector is nearer to
  /// the guide than one with this overlap
  static constexpr double surely_nearest = 0.75;

  /// \param system has prescribed directions; must outlive the object
  /// \param rho must outlive the object
  Directions_selection(Dirac_system& system, const Curvature_potential& rho,
                       const Dirac_options& options);

  /// \param[in,out] s receives the solution
  /// \pre `set_potential(rho)` has been called
  void solve(Dirac_solution& s, const Go_further& go_further);

  /// \brief the smallest singular vectors that belong to zero as far as the edge length tells, see
  /// `Misfit_sizes::averages_out()`: up to four.
  ///
  /// Around each hole there is one more than on a disk, in whose surface the edges need not close.
  /// \param[in,out] s receives the costs
  /// \pre `set_potential(rho)` has been called; rho is on vertices
  Vectors kernel(Dirac_solution& s, const Go_further& go_further) const;

 private:
  /// Iterates one column if it comes near to the guide; otherwise several, of which the relevant
  /// ones converge.
  Eigensolver_result nearest_to_guide(Dirac_solution& s, const Go_further& go_further) const;
  Eigensolver_result smallest(Vectors start, int wanted, double tolerance, Dirac_solution& s,
                              const Go_further& go_further) const;

  /// the first columns, completed by X^-1 of random vectors
  Vectors with_noise(const Vectors& first, int columns) const;

  /// the number of eigenvectors that have to be exact
  int wanted(const Eigensolver_result& r) const;
  static double singular_value(const Eigensolver_result& r, int c);

  /// the overlap with the guide with which a vector is taken, whatever its eigenvalue is
  double surely_taken() const;

  /// whether its eigenvalue is zero up to the discretisation error, if there are eigenvalues
  bool is_zero(const Eigensolver_result& r, int c) const;

  /// whether a column is a solution up to the discretisation error
  bool is_solution(const Eigensolver_result& r, int c) const;

  /// the column of the requested branch, preferably of a solution
  int column(const Eigensolver_result& r) const;

  /// the number of singular values that count as zero; zero and one have the same effect
  int size_of_kernel(const Eigensolver_result& r) const;

  /// \brief the distance between the eigenvalues of the vectors from `first` to before `end`, and
  /// the nearest of the others; zero if there are none. Where D is self-adjoint, these are signed.
  double gap(const Eigensolver_result& r, int first, int end) const;

  /// takes the vector nearest to the guide, or the projection of the guide onto the kernel
  void take(const Eigensolver_result& r, Dirac_solution& s) const;

  const Quaternion_vector<double>& guide() const { return m_system.directions()->guide(); }

  Dirac_system& m_system;
  const Curvature_potential& m_rho;
  Dirac_options m_options;
  double m_greatest_value;       // singular, of a solution
  double m_greatest_eigenvalue;  // modulus that counts as zero, if it is not a misfit
};

}  // namespace Conformal_geometry_processing::internal
