// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRUM_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRUM_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// which eigenvalues of D - rho, and how exactly
struct Dirac_spectrum_options {
  double shift = 0;         ///< those nearest to it, in 1/length
  double tolerance = 1e-8;  ///< on `Dirac_spectrum::residuals`
  int max_restarts = 100;
  unsigned random_seed = 0;
};

/// \ingroup PkgSpin
/// \brief eigenvalues and eigenfunctions of D - rho, those nearest to a shift first.
///
/// On closed surfaces eigenfunctions are spaces over the quaternions, lambda and lambda q together,
/// and each such space counts once. With directions kept at a boundary they are spaces over the
/// reals.
struct Dirac_spectrum {
  /// with their sign, in 1/length: `dirac_quotient()` of the vectors
  Eigen::VectorXd eigenvalues;
  /// those of A*A lambda = g B*A lambda for A = D - rho - shift, plus the shift [CGP (5.2)]:
  /// farther from the shift by the squared error of discretisation over the distance to it
  Eigen::VectorXd pencil_eigenvalues;
  Eigen::VectorXd residuals;          ///< relative, of the discrete problem
  Block<Quaternion<double>> vectors;  ///< |V| x count; the mean of |lambda|^2 is one
  int size_of_constants = 0;  ///< the first ones are constant spins, with their eigenvalue exactly
  int restarts = 0;           ///< of the iteration
  bool converged = false;
  bool cancelled = false;

  Eigen::Index size() const { return eigenvalues.size(); }
};

/// \ingroup PkgSpin
/// one eigenvalue with its copies
struct Multiple_eigenvalue {
  double value;  ///< the mean
  int multiplicity;
};

/// \ingroup PkgSpin
/// \brief eigenvalues that differ from the next one by less than a given distance, as one;
/// ascending. \param resolution what the discretisation takes apart is nearer to each other
std::vector<Multiple_eigenvalue> with_multiplicities(const Eigen::VectorXd& eigenvalues,
                                                     double resolution);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Dirac_spectrum_impl.h>
#endif

#endif
