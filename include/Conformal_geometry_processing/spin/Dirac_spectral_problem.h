// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRAL_PROBLEM_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRAL_PROBLEM_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/krylov_schur.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>

#include <Eigen/Core>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgSpin
/// \brief finds the eigenvalues nearest to a shift s, and eigenfunctions, of D - rho, on closed
/// surfaces and on surfaces with boundary where D is self-adjoint [CGP (5.2), 5.8.2].
///
/// With A = D - rho - s, these are the eigenpairs of A*A lambda = g B*A lambda with the largest
/// |1/g|, which the Krylov-Schur method finds. A*A is positive definite and is factored once per
/// call of `find()`. For A = D it is singular: the constants are in the kernel of both sides and
/// determine no eigenvalue. They are split off first, and the other eigenfunctions have mean zero.
///
/// The eigenvalue of this pencil is s + (g_0^2 + delta^2) / g_0, where s + g_0 is the true
/// eigenvalue and delta the discretisation error. Vectors nearer to the shift than delta therefore
/// appear farther away than others; they are computed from the standard problem [CGP (5.3)] with
/// the same factor. The returned eigenvalues are quotients of the vectors, with an error of O(h^2)
/// for any shift.
///
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class SolverTraits = Default_solver_traits>
class Dirac_spectral_problem {
  using Vectors = Block<Quaternion<double>>;
  using Go_further = std::function<bool(const Krylov_progress&)>;

 public:
  /// \param mesh is copied
  /// \param condition for surfaces with boundary: directions orthogonal to the tangents, such as
  /// binormals
  /// \param function named in exceptions
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with finite
  /// coordinates and positive areas, or the condition does not fit it
  /// \throw Solver_error if the analysis fails
  explicit Dirac_spectral_problem(const Mesh_view& mesh, const Boundary_condition& condition = {},
                                  const std::string& function = "Dirac_spectral_problem");

  /// \param rho finite, in 1/length
  /// \param count the number of eigenvalues
  /// \param go_further called regularly with a `Krylov_progress`; cancels by returning false
  /// \throw Precondition_error if rho does not fit the mesh, or there are fewer than `count`
  /// eigenvalues
  /// \throw Solver_error if a matrix cannot be factored. Failure to converge is a field of the
  /// result.
  Dirac_spectrum find(const Curvature_potential& rho, int count,
                      const Dirac_spectrum_options& options = {},
                      const Go_further& go_further = {});

 private:
  /// an eigenvector with its quotient and its eigenvalue of the pencil, both minus the shift, in
  /// the frame
  struct Pair {
    double quotient, of_pencil, residual;
    Quaternion_vector<double> vector;

    friend bool operator<(const Pair& a, const Pair& b)
    {
      return std::abs(a.quotient) < std::abs(b.quotient);
    }
  };

  static const Mesh_view& checked(const Mesh_view& mesh, const Boundary_condition& condition,
                                  const std::string& function);
  void require_input(const Curvature_potential& rho, int count, double shift) const;

  Krylov_result iterate(const Pencil& pencil, int wanted, const Dirac_spectrum_options& options,
                        const Go_further& go_further = {}) const;

  Pair pair(const Quaternion_vector<double>& v, double residual) const;

  /// \brief the eigenpairs nearest to the shift first; replaces those that the pencil misplaces.
  std::vector<Pair> with_those_at_the_shift(const Krylov_result& r,
                                            const Dirac_spectrum_options& options) const;

  /// \brief the eigenvectors nearer to the shift than the discretisation error: those of X lambda =
  /// mu M_V lambda [CGP (5.3)] with sqrt(mu) below the moduli of all eigenvalues of the pencil. For
  /// all other vectors, sqrt(mu) nearly equals such a modulus.
  std::vector<Pair> at_the_shift(const Krylov_result& r,
                                 const Dirac_spectrum_options& options) const;

  /// the number of vectors with sqrt(mu) below a bound
  int count_below(double bound, const Krylov_result& standard) const;
  /// <v, X v>
  double energy(const Quaternion_vector<double>& v) const;
  void set_potential(Curvature_potential rho);
  void fill(const std::vector<Pair>& pairs, double shift, Dirac_spectrum& s) const;

  std::string m_function;
  Normalized_frame m_frame;
  Mesh_view m_mesh;  // in the frame
  Dirac_system<SolverTraits> m_system;
  Curvature_potential m_rho;  // with the shift, in the frame
  Vectors m_constants;        // in the kernel of D - rho, and excluded
};

}  // namespace internal

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Dirac_spectral_problem_templates.h>
#endif

#endif
