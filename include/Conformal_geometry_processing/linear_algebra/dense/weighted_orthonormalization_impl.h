// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_WEIGHTED_ORTHONORMALIZATION_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DENSE_WEIGHTED_ORTHONORMALIZATION_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/dense/hermitian_jacobi.h>
#include <Conformal_geometry_processing/linear_algebra/dense/weighted_orthonormalization.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE void require_weighted_functions(const Eigen::MatrixXd& functions,
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

CGP_INLINE Eigen::MatrixXd weighted_gram_matrix(const Eigen::MatrixXd& functions,
                                                const Eigen::VectorXd& weights)
{
  Eigen::MatrixXd gram(functions.cols(), functions.cols());
  for (Eigen::Index j = 0; j < gram.cols(); ++j) {
    const Eigen::VectorXd weighted = weights.cwiseProduct(functions.col(j));
    for (Eigen::Index i = 0; i <= j; ++i) gram(i, j) = gram(j, i) = weighted.dot(functions.col(i));
  }
  return gram;
}

CGP_INLINE void orthonormalize_in_order(Eigen::MatrixXd& basis, const Eigen::VectorXd& weights)
{
  for (Eigen::Index j = 0; j < basis.cols(); ++j) {
    for (Eigen::Index i = 0; i < j; ++i)
      basis.col(j) -= weights.cwiseProduct(basis.col(i)).dot(basis.col(j)) * basis.col(i);
    basis.col(j) /= std::sqrt(weights.cwiseProduct(basis.col(j)).dot(basis.col(j)));
  }
}

}  // namespace internal

CGP_INLINE Eigen::MatrixXd weighted_orthonormalization(const Eigen::MatrixXd& functions,
                                                       const Eigen::VectorXd& weights,
                                                       double threshold)
{
  internal::require_weighted_functions(functions, weights);
  if (functions.cols() == 0) return functions;
  const auto gram = hermitian_jacobi(internal::weighted_gram_matrix(functions, weights));
  const Eigen::VectorXd squared = gram.values.reverse();  // decreasing
  const Eigen::Index rank =
      squared[0] > 0 ? (squared.array() > threshold * threshold * squared[0]).count() : 0;
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(functions.rows(), rank);
  for (Eigen::Index r = 0; r < rank; ++r)
    for (Eigen::Index j = 0; j < functions.cols(); ++j)
      basis.col(r) += gram.vectors(j, gram.vectors.cols() - 1 - r) * functions.col(j);
  for (Eigen::Index r = 0; r < rank; ++r) basis.col(r) /= std::sqrt(squared[r]);
  // The basis is already orthonormal up to rounding / threshold^2, so that the Gram-Schmidt process
  // hardly mixes the directions.
  internal::orthonormalize_in_order(basis, weights);
  return basis;
}

CGP_INLINE Eigen::VectorXd weighted_singular_values(const Eigen::MatrixXd& functions,
                                                    const Eigen::VectorXd& weights)
{
  internal::require_weighted_functions(functions, weights);
  if (functions.cols() == 0) return {};
  const auto gram = hermitian_jacobi(internal::weighted_gram_matrix(functions, weights));
  return gram.values.reverse().cwiseMax(0).cwiseSqrt();
}

CGP_INLINE Eigen::VectorXd project_out(const Eigen::MatrixXd& basis, const Eigen::VectorXd& weights,
                                       Eigen::VectorXd v)
{
  Eigen::VectorXd coefficients(basis.cols());
  for (int pass = 0; pass < 2; ++pass) {
    const Eigen::VectorXd weighted = weights.cwiseProduct(v);
    for (Eigen::Index j = 0; j < basis.cols(); ++j) coefficients[j] = basis.col(j).dot(weighted);
    for (Eigen::Index j = 0; j < basis.cols(); ++j) v -= coefficients[j] * basis.col(j);
  }
  return v;
}

}  // namespace Conformal_geometry_processing

#endif
