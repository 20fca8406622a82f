// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_EIGENSOLVER_RESULT_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_EIGENSOLVER_RESULT_H

#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>

#include <functional>
#include <optional>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief Stopping criteria of an eigensolver.
struct Eigensolver_options {
  int wanted = 1;            ///< how many of the smallest eigenpairs have to converge
  int max_iterations = 100;  ///< maximal number of iterations
  double tolerance = 1e-6;   ///< bound on `Eigensolver_result::estimates`
  /// Square root of a typical eigenvalue, sqrt(4 pi / area) on a surface; makes the error estimate
  /// dimensionless
  double scale = 1;
  /// Coefficients of linear combinations; `reals` if the vectors form a space over the reals only
  internal::Coefficients coefficients = internal::Coefficients::quaternions;
};

/// \ingroup PkgLinearAlgebra
/// \brief Progress reported before every iteration.
struct Eigensolver_progress {
  int iteration;    ///< iterations done
  double value;     ///< current approximation of the smallest eigenvalue
  double estimate;  ///< the largest error estimate of the wanted vectors
  const Block<Quaternion<double>>* vectors = nullptr;  ///< the iterates, if provided
};

namespace internal {

/// \ingroup PkgLinearAlgebra
/// \brief Never cancels: the default for the `go_further` of eigensolvers.
struct Always_go_further {
  bool operator()(const Eigensolver_progress&) const { return true; }
};

/// \ingroup PkgLinearAlgebra
/// Called after every iteration; returns false to cancel
using Go_further = std::function<bool(const Eigensolver_progress&)>;

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief The smallest eigenpairs of K x = N x theta, with error estimates.
///
/// `estimates` are sqrt(<r, T r>) / scale of the returned vectors, with r = K x - N x theta and T
/// approximately the inverse of K: the error of x in the energy norm of K. The error of theta is
/// about the square of it, so theta appears to converge long before x.
struct Eigensolver_result {
  Vector<double> values;              ///< ascending
  Block<Quaternion<double>> vectors;  ///< |V| x block size, X^H N X = 1
  Vector<double> estimates;           ///< one per vector
  int iterations = 0;
  int solves = 0;          ///< applications of T, to all columns at once
  bool converged = false;  ///< every wanted estimate is at most the tolerance
  bool stagnated = false;  ///< rounding errors keep the estimate above the tolerance
  bool cancelled = false;  ///< `go_further` returned false
  std::optional<double>
      gap;  ///< theta_2 - theta_1, if the block has at least two columns; otherwise the smallest
            ///< upper bound found, if any, which is rough for wide gaps
};

}  // namespace Conformal_geometry_processing

#endif
