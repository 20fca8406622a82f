// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/exceptions.h>
#include <Quaternionic_linear_algebra/krylov/Krylov_space.h>

#include <Eigen/Core>

#include <functional>

namespace Conformal_geometry_processing {
namespace internal {

/// Number of eigenpairs, and stopping criteria
struct Krylov_options {
  int wanted = 1;
  double tolerance = 1e-9;  ///< bound on `Krylov_result::residuals`
  int max_restarts = 100;   ///< one at least is needed to look for further copies
};

/// Progress reported after every block of vectors
struct Krylov_progress {
  int restart = 0;    ///< restarts done
  int converged = 0;  ///< wanted eigenpairs found so far
  int vectors = 0;    ///< in the space
  int capacity = 0;   ///< of the space: a restart comes when it is full, or before
};

/// \brief Eigenpairs of K x = theta N x of the largest |theta|, with their residuals.
struct Krylov_result {
  Vector<double> values;              ///< descending in modulus, of either sign
  Block<Quaternion<double>> vectors;  ///< n x wanted, X^H N X = 1
  Vector<double> residuals;  ///< |N^-1 K x - theta x| / |theta| in the norm of N, recomputed
  int restarts = 0;
  bool converged = false;
  bool cancelled = false;
};

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief Computes the eigenpairs of K x = theta N x with the largest |theta|, for indefinite K, by
/// the block Krylov-Schur method (a Lanczos method with restarts) over the quaternions.
///
/// With N = (A - s)^2 and K = A - s those are the eigenvalues s + 1/theta of A next to s. Full
/// orthogonalization makes it possible to find multiple eigenvalues: as many copies as a block has
/// columns, sqrt(wanted) - 1 or at least three; further copies are found by restarts from two
/// random vectors beside all pairs whenever these have converged, until they stay as they are and
/// the next pair is seen to be another one. Looks at the pairs whenever the space has grown by an
/// eighth. Deterministic, if `noise` is.
///
/// Costs one K, one solution, two N and about 100 (wanted + 6 sqrt(wanted)) n operations for each
/// of the vectors; the memory of wanted + 12 sqrt(wanted) of them.
///
/// \param rows n
/// \param noise called with a number of columns: returns that many vectors in the space, new ones
/// each time
/// \param go_further called with `Krylov_progress` after every block; false cancels
/// \param known eigenpairs of the same pencil, converged to the same tolerance, such as those of a
/// run that wanted fewer: they are kept and not computed again
/// \pre `known` are at most as many as are wanted
/// \throw Precondition_error if `wanted` is less than one or exceeds the number of eigenpairs
/// \throw Solver_error if an operator returns values that are not finite
internal::Krylov_result krylov_schur(
    const internal::Pencil& pencil, Eigen::Index rows,
    const std::function<Block<Quaternion<double>>(Eigen::Index)>& noise,
    const internal::Krylov_options& options = {},
    const std::function<bool(const internal::Krylov_progress&)>& go_further = {},
    const internal::Krylov_result& known = {});

}  // namespace Conformal_geometry_processing
