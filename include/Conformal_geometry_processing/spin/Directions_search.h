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
/// into prescribed ones: the smallest singular value of D - rho on that space, or one of the next
/// whose vector is nearer to the guide [CGP 5.7]. Where gamma is only a misfit, no vector with a
/// great one is taken if there are others (`greatest_misfit()`).
///
/// The space is one over the real numbers, so eigenvalues are simple in general and not fourfold.
/// Per `solve()`: one factorization, and one solve for each iteration and column.
template <class SolverTraits>
class Directions_search {
  using Vectors = Block<Quaternion<double>>;

 public:
  /// squares of overlaps with orthogonal vectors add up to at most one, so that no other vector is
  /// nearer to the guide than one with this overlap
  static constexpr double surely_nearest = 0.75;

  /// \param system with prescribed directions; must outlive the object
  explicit Directions_search(Dirac_system<SolverTraits>& system) : m_system(system) {}

  /// \param[in,out] s is filled in
  /// \pre `set_potential(rho)` has been called
  void solve(const Curvature_potential& rho, const Dirac_options& options, Dirac_solution& s,
             const Go_further& go_further);

 private:
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

  const Quaternion_vector<double>& guide() const { return m_system.directions()->guide(); }

  Dirac_system<SolverTraits>& m_system;
};

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Directions_search_templates.h>
#endif

#endif
