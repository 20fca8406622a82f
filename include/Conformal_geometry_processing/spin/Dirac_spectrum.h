// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
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

/// \brief eigenvectors of A = D - rho - s with their quotients, of a space that contains every
/// eigenvector of X with an energy below `reach`.
struct Spectral_pairs {
  Eigen::VectorXd quotients;       ///< `dirac_quotient()`, without the shift
  Eigen::VectorXd energies;        ///< <v, X v> / <v, M_V v>
  Eigen::VectorXd squared_images;  ///< |D v|^2 / <v, M_V v>, without rho and shift
  Eigen::VectorXd of_pencil;       ///< <v, X v> / <v, K v> [CGP (5.2)]
  Eigen::VectorXd residuals;
  Block<Quaternion<double>> vectors;
  double reach = 0;
  double slow_energy = 0;           ///< |D v|^2 of waves as long as twenty edges
  bool is_limited_by_mesh = false;  ///< more vectors do not increase the reach

  Eigen::Index size() const { return quotients.size(); }
};

/// \brief the energy that the first `count` pairs have beyond the squares of their quotients, at
/// most: the square of the discretisation error delta, not negative.
double squared_error(const Spectral_pairs& pairs, Eigen::Index count);

/// \brief the energy below which the `count` eigenvalues nearest to the shift lie, with those
/// missing if their squared errors are up to twice as large as those of the pairs.
/// \pre nearest first, 0 < count <= pairs.size()
double needed_reach(const Spectral_pairs& pairs, Eigen::Index count);

/// \brief the distance from the shift within which no eigenvalue is missing among the first `count`
/// pairs.
///
/// An eigenvalue s + g that is missing has g^2 + delta^2 >= `reach`, or comes later in the list.
/// Its delta is taken to be at most sqrt(2) of the largest of the pairs nearer to the shift. Zero
/// if nothing is certain, and infinite if the pairs are all there are.
/// \pre nearest first
double complete_radius(const Spectral_pairs& pairs, Eigen::Index count);

/// whether the first `count` pairs exist, within `complete_radius()`
bool is_window_complete(const Spectral_pairs& pairs, Eigen::Index count);

/// \brief the pairs that the mesh resolves, in the order of |quotient|.
///
/// A vector that oscillates from edge to edge is orthogonal to its image under D, and its quotient
/// is a number near -rho - s without a meaning: it is not resolved if its squared error is more
/// than half of |D v|^2, and that exceeds 1 / h^2. (Eigenvectors next to zero have small images,
/// and on a jagged boundary an error as large, which leaves them what they are.) Nor is it if the
/// square of the quotient exceeds the energy by as much: averaging to faces cancels it. What such
/// vectors have displaced may be missing from their energy on, which limits the reach.
Spectral_pairs resolved_nearest_first(const Spectral_pairs& pairs);

/// enough for what cuts through a multiple eigenvalue at the end, or a pair of opposite sign
int first_subspace_size(int count);

/// \brief a larger size, at most doubled and at most `most`, where `size` left eigenvalues out: the
/// number of eigenvectors of X grows like the energy up to which they are counted (Weyl).
/// \param pairs those found with `size`
int next_subspace_size(int size, int most, const Spectral_pairs& pairs, int count);

/// \brief where the search is given up: more eigenvectors are only needed if the discretisation
/// error far exceeds the distances of the eigenvalues.
int largest_subspace_size(int count);

/// Eigenvectors of an operator, found as combinations of those of its square
struct Signed_eigenvectors {
  Block<Quaternion<double>> vectors;  ///< M-orthonormal
  Vector<double> residuals;           ///< of the eigenvectors of the square, combined likewise
  /// every eigenvector of the square whose eigenvalue (that of N x = mu M x) is less, is in the
  /// span
  double reach = 0;
};

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

/// \ingroup PkgSpin
/// \brief separates the eigenvectors of an operator K that its square N has mixed because their
/// eigenvalues differ by the sign only.
///
/// The span of *all* eigenvectors of N with eigenvalues below a bound is invariant under K, and
/// Rayleigh-Ritz of K in it tells the signs. Of a finite number of vectors, the last ones may be
/// mixtures with vectors that are missing: their images N^-1 K v leave the span by about |v| /
/// sqrt(mu), those of all others by the discretisation error. They are left out. Only vectors whose
/// mu differ by less than a factor of two, or whose coupling <v, K w> is too large for an error of
/// discretisation, are combined: others are not mixed.
///
/// Costs one K and one solution for each vector, and some n^2 products of |V| quaternions and n^3.
/// \param form K, and N^-1
/// \param square the eigenpairs of M x = theta N x with the n largest theta > 0
/// \throw Solver_error if an operator returns values that are not finite
internal::Signed_eigenvectors signed_eigenvectors(const internal::Pencil& form,
                                                  const internal::Krylov_result& square);

/// \ingroup PkgSpin
/// \brief merges eigenvalues that differ from the next one by less than a given distance;
/// ascending.
/// \param resolution more than the discretisation separates multiple eigenvalues by
std::vector<internal::Multiple_eigenvalue> with_multiplicities(const Eigen::VectorXd& eigenvalues,
                                                               double resolution);

}  // namespace Conformal_geometry_processing
