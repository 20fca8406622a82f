// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_WEIGHTED_ORTHONORMALIZATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_WEIGHTED_ORTHONORMALIZATION_H

#include <Conformal_geometry_processing/exceptions.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {
namespace internal {

inline void require_weighted_functions(const Eigen::MatrixXd& functions,
                                       const Eigen::VectorXd& weights)
{
  const std::string name = "weighted_orthonormalization";
  if (functions.rows() != weights.size())
    throw Precondition_error(name, std::to_string(weights.size()) +
                                       " weights, one per row of the functions is needed: " +
                                       std::to_string(functions.rows()));
  for (Eigen::Index i = 0; i < weights.size(); ++i)
    if (!(weights[i] > 0) || !std::isfinite(weights[i]))
      throw Precondition_error(name, "weight " + std::to_string(i) + " is " +
                                         std::to_string(weights[i]) +
                                         "; positive numbers are needed");
  for (Eigen::Index j = 0; j < functions.cols(); ++j)
    if (!functions.col(j).allFinite())
      throw Precondition_error(name,
                               "function " + std::to_string(j) + " has a value that is not finite");
}

inline Eigen::MatrixXd weighted_gram_matrix(const Eigen::MatrixXd& functions,
                                            const Eigen::VectorXd& weights)
{
  return functions.transpose() * weights.asDiagonal() * functions;
}

}  // namespace internal

/// \ingroup PkgLinearAlgebra
/// \brief an orthonormal basis of the span of some functions, in the inner product
/// sum_i w_i a_i b_i, without the directions in which they hardly extend.
///
/// Directions whose singular value is below `threshold` times the largest are dropped: functions
/// that depend on each other up to rounding or discretisation errors differ by nothing but noise,
/// which a plain Gram-Schmidt process would normalise. Functions should be scaled alike; none at
/// all, and functions that vanish, have the empty basis.
///
/// From the eigenvectors of the Gram matrix, and once more from its Cholesky factor, which makes
/// the basis orthonormal to rounding. Deterministic. About 8 n k^2 operations, and the memory of
/// the functions once more.
///
/// \param functions n x k, one per column
/// \param weights n positive numbers
/// \param threshold at least 1e-7: the Gram matrix knows no smaller singular values
/// \returns n x r, r <= k, in the order of decreasing singular values
/// \throw Precondition_error if the sizes differ, a weight is not positive or a value not finite
inline Eigen::MatrixXd weighted_orthonormalization(const Eigen::MatrixXd& functions,
                                                   const Eigen::VectorXd& weights,
                                                   double threshold = 1e-3)
{
  internal::require_weighted_functions(functions, weights);
  if (functions.cols() == 0) return functions;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(
      internal::weighted_gram_matrix(functions, weights));
  const Eigen::VectorXd squared = gram.eigenvalues().reverse();  // decreasing
  const Eigen::Index rank =
      squared[0] > 0 ? (squared.array() > threshold * threshold * squared[0]).count() : 0;
  Eigen::MatrixXd basis = functions * gram.eigenvectors().rowwise().reverse().leftCols(rank);
  basis *= squared.head(rank).cwiseSqrt().cwiseInverse().asDiagonal();
  // Orthonormal up to rounding / threshold^2. What remains goes with the Cholesky factor of the
  // Gram matrix, which is almost the identity, and does not mix the directions anew.
  const Eigen::LLT<Eigen::MatrixXd> rest(internal::weighted_gram_matrix(basis, weights));
  rest.matrixU().solveInPlace<Eigen::OnTheRight>(basis);
  return basis;
}

/// \ingroup PkgLinearAlgebra
/// \brief the singular values of some functions in the inner product sum_i w_i a_i b_i, decreasing;
/// those below 1e-7 of the largest are rounding errors. 2 n k^2 operations.
/// \throw Precondition_error as `weighted_orthonormalization()`
inline Eigen::VectorXd weighted_singular_values(const Eigen::MatrixXd& functions,
                                                const Eigen::VectorXd& weights)
{
  internal::require_weighted_functions(functions, weights);
  if (functions.cols() == 0) return {};
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(
      internal::weighted_gram_matrix(functions, weights), Eigen::EigenvaluesOnly);
  return gram.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
}

/// \ingroup PkgLinearAlgebra
/// \brief v without its part in the span of a basis that is orthonormal with the weights.
///
/// Projects twice, so that a v almost inside the span is left with rounding errors of its own size
/// that are orthogonal all the same. 8 n k operations.
/// \pre `basis` is what `weighted_orthonormalization()` returned for these weights
inline Eigen::VectorXd project_out(const Eigen::MatrixXd& basis, const Eigen::VectorXd& weights,
                                   Eigen::VectorXd v)
{
  for (int pass = 0; pass < 2; ++pass)
    v -= basis * (basis.transpose() * weights.cwiseProduct(v)).eval();
  return v;
}

}  // namespace Conformal_geometry_processing

#endif
