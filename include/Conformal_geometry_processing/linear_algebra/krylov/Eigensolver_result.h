// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_EIGENSOLVER_RESULT_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_KRYLOV_EIGENSOLVER_RESULT_H

#include <Conformal_geometry_processing/linear_algebra/dense/block_products.h>

#include <functional>
#include <optional>

namespace Conformal_geometry_processing {

/// \ingroup PkgLinearAlgebra
/// \brief when an eigenvalue solver stops.
struct Eigensolver_options {
  int wanted = 1;            ///< how many of the smallest eigenpairs have to converge
  int max_iterations = 100;  ///< gives up after as many
  double tolerance = 1e-6;   ///< on `Eigensolver_result::estimates`
  /// the square root of an eigenvalue of typical size, sqrt(4 pi / area) on a surface: makes the
  /// error estimate a pure number
  double scale = 1;
  /// of combinations of vectors; `reals` where the vectors are a space over the reals only
  Coefficients coefficients = Coefficients::quaternions;
};

/// \ingroup PkgLinearAlgebra
/// \brief what is reported before every iteration.
struct Eigensolver_progress {
  int iteration;    ///< iterations done
  double value;     ///< the smallest eigenvalue, so far
  double estimate;  ///< the largest error estimate of the wanted vectors
  const Block<Quaternion<double>>* vectors = nullptr;  ///< the iterates, if the solver shows them
};

/// \ingroup PkgLinearAlgebra
/// \brief goes on in any case: the default for the `go_further` of eigenvalue solvers.
struct Always_go_further {
  bool operator()(const Eigensolver_progress&) const { return true; }
};

/// \ingroup PkgLinearAlgebra
/// asked after every iteration; false cancels
using Go_further = std::function<bool(const Eigensolver_progress&)>;

/// \ingroup PkgLinearAlgebra
/// \brief the smallest eigenpairs of K x = N x theta, with the evidence for them.
///
/// `estimates` are sqrt(<r, T r>) / scale of the returned vectors, with r = K x - N x theta and T
/// nearly the inverse of K: the error of x in the energy norm of K. The error of theta is about the
/// square of it, so theta would look converged long before x is.
struct Eigensolver_result {
  Vector<double> values;              ///< ascending
  Block<Quaternion<double>> vectors;  ///< |V| x block size, X^H N X = 1
  Vector<double> estimates;           ///< one per vector
  int iterations = 0;
  int solves = 0;          ///< applications of T, to all columns at once
  bool converged = false;  ///< every wanted estimate is at most the tolerance
  bool stagnated = false;  ///< rounding errors keep the estimate above the tolerance
  bool cancelled = false;  ///< `go_further` said no
  std::optional<double>
      gap;  ///< theta_2 - theta_1, if the block has two columns or more; with one,
            ///< the least upper bound met, if any: rough where the gap is wide
};

}  // namespace Conformal_geometry_processing

#endif
