// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>
#include <Quaternionic_linear_algebra/krylov/krylov_schur.h>

#include <Eigen/Core>

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

}  // namespace Conformal_geometry_processing
