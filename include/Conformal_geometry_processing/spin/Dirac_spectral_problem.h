// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Visit_guard.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/krylov_schur.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Spectral_pairs.h>

#include <Eigen/Core>

#include <functional>
#include <string>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief finds the eigenvalues nearest to a shift s, and eigenfunctions, of D - rho, on closed
/// surfaces and on surfaces with boundary where D is self-adjoint [CGP 5.8.2].
///
/// The eigenvectors of X lambda = mu M_V lambda [CGP (5.3)] for A = D - rho - s with the smallest
/// mu = g^2 + delta^2 span those of A with |g| below a bound, where delta is the discretisation
/// error; Rayleigh-Ritz of the signed form in this span separates s + g from s - g. Nothing depends
/// on the distance of the shift to an eigenvalue, and X is factored once per call of `find()`,
/// shifted to be well conditioned. The pencil A*A lambda = g B*A lambda [CGP (5.2)] would find the
/// same vectors except those with |g| < delta, whose eigenvalues (g^2 + delta^2) / g are anywhere.
///
/// More vectors are computed until the discretisation error leaves none of the wanted ones out
/// (`complete_radius()`); those found are kept. The returned eigenvalues are quotients of the
/// vectors, with an error of O(h^2) for any shift. For rho + s = 0, the constants are split off
/// first, and the other eigenfunctions have mean zero.
///
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
                                  const std::string& function = "Dirac_spectral_problem",
                                  const Spin_solvers& solvers = {});

  /// \param rho finite, in 1/length
  /// \param count the number of eigenvalues
  /// \param go_further called regularly with a `Krylov_progress`; cancels by returning false
  /// \throw Precondition_error if rho does not fit the mesh, there are fewer than `count`
  /// eigenvalues, or `go_further` calls this function back
  /// \throw Solver_error if a matrix cannot be factored. Failure to converge is a field of the
  /// result.
  Dirac_spectrum find(const Curvature_potential& rho, int count,
                      const Dirac_spectrum_options& options = {},
                      const Go_further& go_further = {});

 private:
  static const Mesh_view& checked(const Mesh_view& mesh, const Boundary_condition& condition,
                                  const std::string& function);
  void require_input(const Curvature_potential& rho, int count, double shift) const;

  /// the number of eigenvectors besides the constants
  int size_of_space() const;

  /// computes eigenvectors until the `wanted` ones nearest to the shift are complete
  void search(int wanted, const Dirac_spectrum_options& options, const Go_further& go_further,
              Dirac_spectrum& s) const;

  Krylov_result iterate(int wanted, const Krylov_result& known,
                        const Dirac_spectrum_options& options, const Go_further& go_further) const;

  /// in the frame, nearest to the shift first
  Spectral_pairs pairs(const Krylov_result& square) const;

  void set_potential(Curvature_potential rho);
  void append_constants(int count, Dirac_spectrum& s) const;
  void append(const Spectral_pairs& pairs, int count, Dirac_spectrum& s) const;

  std::string m_function;
  Visit_guard m_visits;
  Normalized_frame m_frame;
  Mesh_view m_mesh;  // in the frame
  Dirac_system m_system;
  Curvature_potential m_rho;  // with the shift, in the frame
  Vectors m_constants;        // in the kernel of D - rho, and excluded
};

}  // namespace Conformal_geometry_processing::internal
