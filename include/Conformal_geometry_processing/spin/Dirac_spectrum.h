// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Conformal_geometry_processing/spin/Spectral_pairs.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/Visit_guard.h>
#include <Quaternionic_linear_algebra/krylov/krylov_schur.h>

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// which eigenvalues of D - rho are computed, and how accurately
struct Dirac_spectrum_options {
  double shift = 0;         ///< the eigenvalues nearest to it are found; in 1/length
  double tolerance = 1e-8;  ///< upper bound of `Dirac_spectrum::residuals`
  int max_restarts = 100;
  unsigned random_seed = 0;
};

/// \brief eigenvalues and eigenfunctions of D - rho, those nearest to a shift first.
///
/// On closed surfaces, eigenspaces are quaternionic (lambda q is an eigenfunction if lambda is),
/// and each quaternionic dimension counts once. With directions kept at a boundary, they are real
/// vector spaces.
struct Dirac_spectrum {
  double shift = 0;  ///< the eigenvalues nearest to it; in 1/length
  int wanted = 0;    ///< the number of eigenvalues that were asked for
  /// signed, in 1/length: `dirac_quotient()` of the vectors
  Eigen::VectorXd eigenvalues;
  /// <v, A*A v> / <v, B*A v> for A = D - rho - shift, plus the shift, which is the eigenvalue of
  /// [CGP (5.2)] up to the square of the error of v: its distance to the shift is too large by the
  /// squared discretisation error over that distance, and not meaningful below that error
  Eigen::VectorXd pencil_eigenvalues;
  Eigen::VectorXd residuals;  ///< relative, of the discrete problem [CGP (5.3)] in the whole space
  Block<Quaternion<double>> vectors;  ///< |V| x count; the mean of |lambda|^2 is one
  int size_of_constants = 0;          ///< number of constant spins, which come first, with exact
                                      ///< eigenvalues
  /// Every eigenvalue nearer to the shift than this is listed, as often as its multiplicity, if its
  /// squared discretisation error is at most twice those of the listed: an estimate, and no bound,
  /// for nothing on a mesh bounds the error of an eigenvalue that it resolves much worse than its
  /// neighbours. In 1/length. Others are eigenvalues too, but some between them may be missing.
  /// Infinite if all are listed.
  double complete_radius = 0;
  int restarts = 0;        ///< of the iteration
  bool converged = false;  ///< the iteration for the discrete problem
  bool cancelled = false;

  Eigen::Index size() const { return eigenvalues.size(); }

  /// whether these are the wanted eigenvalues: as many as were asked for, all within
  /// `complete_radius` of the shift
  bool is_complete() const;
};

/// an eigenvalue with its multiplicity
struct Multiple_eigenvalue {
  double value;  ///< mean of the merged values
  int multiplicity;
};

}  // namespace internal

/// \ingroup PkgSpin
/// \brief merges eigenvalues that differ from the next one by less than a given distance;
/// ascending.
/// \param resolution more than the discretisation separates multiple eigenvalues by
std::vector<internal::Multiple_eigenvalue> with_multiplicities(const Eigen::VectorXd& eigenvalues,
                                                               double resolution);

namespace internal {

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

}  // namespace internal
}  // namespace Conformal_geometry_processing
