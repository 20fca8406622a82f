// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// \ingroup PkgSpin
/// which eigenvalues of D - rho are computed, and how accurately
struct Dirac_spectrum_options {
  double shift = 0;         ///< the eigenvalues nearest to it are found; in 1/length
  double tolerance = 1e-8;  ///< upper bound of `Dirac_spectrum::residuals`
  int max_restarts = 100;
  unsigned random_seed = 0;
};

/// \ingroup PkgSpin
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

/// \ingroup PkgSpin
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

}  // namespace Conformal_geometry_processing
