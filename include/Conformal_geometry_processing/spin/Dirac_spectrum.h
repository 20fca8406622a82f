// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRUM_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRUM_H

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
  /// signed, in 1/length: `dirac_quotient()` of the vectors
  Eigen::VectorXd eigenvalues;
  /// eigenvalues of A*A lambda = g B*A lambda for A = D - rho - shift, plus the shift [CGP (5.2)]:
  /// their distance to the shift is too large by the squared discretisation error over that
  /// distance
  Eigen::VectorXd pencil_eigenvalues;
  Eigen::VectorXd residuals;          ///< relative, of the discrete problem
  Block<Quaternion<double>> vectors;  ///< |V| x count; the mean of |lambda|^2 is one
  int size_of_constants = 0;          ///< number of constant spins, which come first, with exact
                                      ///< eigenvalues
  int restarts = 0;                   ///< of the iteration
  bool converged = false;
  bool cancelled = false;

  Eigen::Index size() const { return eigenvalues.size(); }
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

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Dirac_spectrum_impl.h>
#endif

#endif
