// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRECTIONS_SEARCH_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRECTIONS_SEARCH_H

#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

namespace internal {

/// \brief solves (D - rho) lambda = gamma lambda for spins that turn directions at the boundary
/// into prescribed ones: takes the smallest singular value of D - rho on that space, or one of the
/// next whose vector is nearer to the guide [CGP 5.7]. If gamma is only a misfit, a vector whose
/// misfit exceeds `greatest_misfit()` is taken only if there are no others.
///
/// The space is real, so eigenvalues are in general simple and not fourfold. Each `solve()` costs
/// one factorization, and one solve for each iteration and column.
template <class SolverTraits>
class Directions_search {
  using Vectors = Block<Quaternion<double>>;

 public:
  /// squared overlaps with orthogonal vectors sum to at most one, so no other vector is nearer to
  /// the guide than one with this overlap
  static constexpr double surely_nearest = 0.75;

  /// \param system has prescribed directions; must outlive the object
  explicit Directions_search(Dirac_system<SolverTraits>& system) : m_system(system) {}

  /// \param[in,out] s receives the solution
  /// \pre `set_potential(rho)` has been called
  void solve(const Curvature_potential& rho, const Dirac_options& options, Dirac_solution& s,
             const Go_further& go_further);

 private:
  /// Iterates one column if it comes near to the guide; otherwise several, of which the relevant
  /// ones converge.
  Eigensolver_result nearest_to_guide(const Dirac_options& options, double bound, Dirac_solution& s,
                                      const Go_further& go_further) const;
  Eigensolver_result smallest(Vectors start, int wanted, double tolerance,
                              const Dirac_options& options, Dirac_solution& s,
                              const Go_further& go_further) const;

  /// the first columns, completed by X^-1 of random vectors
  Vectors with_noise(const Vectors& first, int columns, unsigned seed) const;

  /// the number of eigenvectors that have to be exact
  int wanted(const Eigensolver_result& r, const Dirac_options& options, double bound) const;
  static double singular_value(const Eigensolver_result& r, int c);

  /// the column of the requested branch, preferably of a solution up to the discretisation error
  int column(const Eigensolver_result& r, const Dirac_options& options, double bound) const;

  /// the number of singular values that count as zero; zero and one have the same effect
  int size_of_kernel(const Eigensolver_result& r, const Dirac_options& options) const;

  /// \brief the distance between the eigenvalues of the vectors from `first` to before `end`, and
  /// the nearest of the others; zero if there are none. Where D is self-adjoint, these are signed.
  double gap(const Curvature_potential& rho, const Eigensolver_result& r, int first, int end) const;

  /// takes the vector nearest to the guide, or the projection of the guide onto the kernel
  void take(const Curvature_potential& rho, const Eigensolver_result& r,
            const Dirac_options& options, double bound, Dirac_solution& s) const;

  const Quaternion_vector<double>& guide() const { return m_system.directions()->guide(); }

  Dirac_system<SolverTraits>& m_system;
};

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Directions_search_templates.h>
#endif

#endif
