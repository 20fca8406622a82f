// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
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

/// \ingroup PkgSpin
/// \brief the energy that the first `count` pairs have beyond the squares of their quotients, at
/// most: the square of the discretisation error delta, not negative.
double squared_error(const Spectral_pairs& pairs, Eigen::Index count);

/// \ingroup PkgSpin
/// \brief the energy below which the `count` eigenvalues nearest to the shift lie, with those
/// missing if their squared errors are up to twice as large as those of the pairs.
/// \pre nearest first, 0 < count <= pairs.size()
double needed_reach(const Spectral_pairs& pairs, Eigen::Index count);

/// \ingroup PkgSpin
/// \brief the distance from the shift within which no eigenvalue is missing among the first `count`
/// pairs.
///
/// An eigenvalue s + g that is missing has g^2 + delta^2 >= `reach`, or comes later in the list.
/// Its delta is taken to be at most sqrt(2) of the largest of the pairs nearer to the shift. Zero
/// if nothing is certain, and infinite if the pairs are all there are. \pre nearest first
double complete_radius(const Spectral_pairs& pairs, Eigen::Index count);

/// \ingroup PkgSpin
/// whether the first `count` pairs exist, within `complete_radius()`
bool is_window_complete(const Spectral_pairs& pairs, Eigen::Index count);

/// \ingroup PkgSpin
/// \brief the pairs that the mesh resolves, in the order of |quotient|.
///
/// A vector that oscillates from edge to edge is orthogonal to its image under D, and its quotient
/// is a number near -rho - s without a meaning: it is not resolved if its squared error is more
/// than half of |D v|^2, and that exceeds 1 / h^2. (Eigenvectors next to zero have small images,
/// and on a jagged boundary an error as large, which leaves them what they are.) Nor is it if the
/// square of the quotient exceeds the energy by as much: averaging to faces cancels it. What such
/// vectors have displaced may be missing from their energy on, which limits the reach.
Spectral_pairs resolved_nearest_first(const Spectral_pairs& pairs);

}  // namespace Conformal_geometry_processing::internal
